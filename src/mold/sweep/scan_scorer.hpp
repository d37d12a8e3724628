// Scores directions by scan-converted maps, at an error far below that of as many samples.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/exact_rays.hpp"
#include "mold/region.hpp"
#include "mold/scan/scan_maps.hpp"
#include "mold/scan/scan_part.hpp"
#include "mold/sweep/direction_scorer.hpp"

namespace moldlight {

/// What the scorers of one part share; everything must outlive them. The part must be closed and its facets
/// wound alike: what hides a facet is known from the facets that face the same way.
struct ScanScorerPart {
  const ScanPart& part;
  const ExactRays& rays;
};

struct ScanScorerSettings {
  int resolution = 512;  // of the maps, [16, 8192]
  double tau_deg = 1.0;
  double lateral = 0.0;  // lateral tolerance in the unit frame
  /// Surface samples if the whole part were near-vertical; for a share of it, that share of them.
  double samples = 30'000;
  bool settle_by_rays = true;  // exact rays for near-vertical samples that the maps leave in doubt
};

/// Up and down facets are measured at texel centres, where a map is as exact as a ray: of a cluster of facets
/// the share of hidden texels, each weighing the facet's area behind it, times the cluster's known area. So
/// surface that is wholly open or wholly hidden, which is most of it, adds no error. Near-vertical facets are
/// measured by surface samples in the maps (WallLookup), those in doubt by exact rays; so are, by rays alone,
/// clusters with too few texels.
class ScanScorer : public DirectionScorer {
 public:
  ScanScorer(const ScanScorerPart& part, const ScanScorerSettings& settings);

  [[nodiscard]] DirectionScore score(const glm::dvec3& direction) override;

 private:
  /// Areas in the unit frame squared.
  struct Estimate {
    RegionValues areas;
    double undercut_variance = 0.0;
    double unsettled = 0.0;  // area of which nothing certain is known; it counts as open
  };
  struct Thin {
    std::uint32_t cluster;
    scan::Layer layer;
  };
  /// Near-vertical facets of a cluster and what their samples say.
  struct Wall {
    double area = 0.0;
    std::array<std::uint32_t, k_region_count> counts{};

    [[nodiscard]] double samples() const;
    void add(const Wall& other);
  };

  void find_cluster_areas();
  void add_clusters(Estimate& estimate);
  void add_thin_clusters(Estimate& estimate);
  void sample_walls(double area);
  void settle_walls();
  void add_walls(Estimate& estimate);
  static void leave_open(Region region, double area, Estimate& estimate);
  [[nodiscard]] double share(double area) const;
  [[nodiscard]] DirectionScore finished(const Estimate& estimate) const;

  ScanScorerPart part_;
  ScanScorerSettings settings_;
  ScanMaps maps_;
  double square_;                                    // model units squared per unit frame squared
  std::vector<std::array<float, 2>> cluster_areas_;  // of up and down facets, unit frame squared
  std::vector<std::uint8_t> mixed_;                  // one a cluster: 0 if no facet of it is near-vertical
  std::vector<Thin> thin_;
  std::array<double, 2> thin_areas_{};
  std::vector<Wall> walls_;  // one a cluster
  // Samples on walls, and which of them are in doubt; the room is kept from direction to direction.
  std::vector<std::uint8_t> verdicts_;
  std::vector<std::uint32_t> sample_clusters_, doubtful_;
  std::vector<glm::vec3> origins_;
  std::array<std::vector<std::uint8_t>, 2> answers_;
};

}  // namespace moldlight
