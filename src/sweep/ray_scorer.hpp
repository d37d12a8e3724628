// Scores directions by exact rays over a fixed set of surface samples.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/facet_geometry.hpp"
#include "mold/exact_rays.hpp"
#include "mold/measure.hpp"
#include "mold/surface_samples.hpp"
#include "sweep/direction_scorer.hpp"
#include "sweep/sample_rays.hpp"

namespace moldlight {

/// What scorers of one part share; everything must outlive them.
struct RayScorerPart {
  const ExactRays& rays;
  const FacetGeometry& geometry;
  const SurfaceSamples& samples;
};

/// Samples are asked in passes, each spread evenly over the part; a direction is given up when its undercut
/// is above the limit by five standard errors of what was seen. Beside another direction it is its change
/// from there that counts, by the samples that have changed: three standard errors of as many that go either
/// way. The cost hardly grows with the facets, the error falls with the samples.
class RayScorer : public DirectionScorer {
 public:
  /// `lateral` is the lateral tolerance in the unit frame, `tau_deg` in degrees.
  RayScorer(const RayScorerPart& part, double tau_deg, double lateral);

  [[nodiscard]] std::vector<DirectionScore> score(std::span<const ScoringTask> tasks) override;

 private:
  struct Tally {
    SampleCounts counts;
    double hidden = 0.0;  // projected, in samples
    std::vector<bool> undercut;
    std::size_t more = 0, fewer = 0;  // samples undercut here and not beside, and the other way round
  };

  [[nodiscard]] DirectionScore score_one(const ScoringTask& task);
  void ask(std::size_t first, std::size_t step, const glm::dvec3& direction);
  void count(const ScoringTask& task, Tally& tally) const;
  enum class Side : std::uint8_t { unknown, below, above };
  [[nodiscard]] Side surely_on_side(const ScoringTask& task, const Tally& tally) const;

  RayScorerPart part_;
  double sine_of_tau_, lateral_;
  SampleRays sample_rays_;
};

}  // namespace moldlight
