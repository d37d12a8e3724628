// The two second-depth maps of a parting direction on the CPU: a scan converter for exactly this job. One
// pass over the facets writes both maps, and what lies in front beside them. Same texel centres, twist and
// extent as the GL maps.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mold/draft.hpp"
#include "mold/map_frame.hpp"
#include "mold/scan/kernel/kernel.hpp"
#include "mold/scan/scan_part.hpp"

namespace moldlight {

struct ScanSettings {
  double tau_deg = 1.0;
  double edge_thickness = 2.0;  // width of the thick concave contour edges in texels
  /// The second-depth maps are left out where less than this share of the part's area is near-vertical: what
  /// is in front is enough for the rest, and takes half the memory.
  double second_depth_from = 0.0;
};

/// One thread's maps; drawing allocates nothing once the part is known.
class ScanMaps {
 public:
  /// `resolution` texels along a side, [16, 8192]; takes 32 bytes a texel, 16 for second-depth maps alone.
  explicit ScanMaps(int resolution, const scan::Kernel& kernel = scan::best_kernel());

  void draw(const ScanPart& part, const MapFrame& frame, const ScanSettings& settings);

  /// The second-depth maps alone, for pictures; sums() are empty then. `second_depth_from` is not asked.
  void draw_second_depth(const ScanPart& part, const MapFrame& frame, const ScanSettings& settings);

  /// Facet + 1 of the +d map (facets that face -d, furthest along +d) or of the -d map; 0 where there is
  /// none.
  [[nodiscard]] std::uint32_t entry(bool plus, int x, int y) const {
    const std::int64_t last = back(plus ? scan::k_down_layer : scan::k_up_layer, x, y);
    return is_present(last) ? scan::facet_of(last) + 1 : 0;
  }

  /// entry() of a whole map, rows from below.
  void copy_entries(bool plus, std::vector<std::uint32_t>& entries) const;
  /// Depths of the same, from 0 next to the light to 1 where nothing is.
  void copy_depths(bool plus, std::vector<float>& depths) const;

  /// The facet of a layer that lies last as seen from the side that it faces.
  [[nodiscard]] std::int64_t back(scan::Layer layer, int x, int y) const {
    return target_.back[layer][static_cast<std::size_t>(y) * static_cast<std::size_t>(target_.pitch) +
                               static_cast<std::size_t>(x)];
  }
  /// False for an entry where no facet is.
  [[nodiscard]] bool is_present(std::int64_t entry) const {
    return scan::generation_of(entry) == target_.generation;
  }

  /// False where the last drawing left the second-depth maps out; their entries mean nothing then.
  [[nodiscard]] bool has_second_depth() const { return has_second_depth_; }

  [[nodiscard]] int resolution() const { return resolution_; }
  [[nodiscard]] const MapFrame& frame() const { return frame_; }

  /// Of the facets, for the direction of the maps.
  [[nodiscard]] FacetClass facet_class(FacetIndex facet) const {
    return static_cast<FacetClass>(classes_[facet]);
  }
  [[nodiscard]] std::span<const FacetIndex> near_vertical() const {
    return {steep_.data(), near_vertical_count_};
  }
  /// Area of a class, and projected along the direction: of all facets, and of the near-vertical ones. Unit
  /// frame squared.
  [[nodiscard]] double class_area(FacetClass of) const { return class_area_[static_cast<std::size_t>(of)]; }
  [[nodiscard]] double projected_area() const { return projected_area_; }
  [[nodiscard]] double projected_near_vertical_area() const { return projected_near_vertical_area_; }
  /// Area of the part's shadow along the direction, from the texels that facets alone cover: the larger of
  /// the two maps' areas, which are equal for a closed part. Unit frame squared.
  [[nodiscard]] double shadow_area() const;

  [[nodiscard]] const scan::RasterSums& sums() const { return sums_; }
  [[nodiscard]] std::span<const float> weights() const { return weights_; }

 private:
  void begin(const ScanPart& part, const MapFrame& frame, double tau_deg);
  void classify(const ScanPart& part, double tau_deg);
  void draw_concave_edges(const ScanPart& part, double half_width);

  int resolution_;
  const scan::Kernel* kernel_;
  std::vector<std::int64_t> front_[2], back_[2];  // by layer
  scan::RasterTarget target_;
  scan::RasterSums sums_;
  std::vector<scan::ClusterSums> cluster_sums_;
  MapFrame frame_;
  scan::Projection projection_;
  std::vector<scan::MapVertex> vertices_;
  std::vector<std::int32_t> classes_;
  std::vector<float> weights_;
  std::vector<FacetIndex> steep_;
  struct Strips {
    std::vector<scan::MapVertex> corners;  // three a triangle
    std::vector<FacetIndex> facets;
  };
  Strips strips_[2];  // by layer
  bool has_second_depth_ = false;
  std::size_t near_vertical_count_ = 0;
  double class_area_[3] = {}, projected_area_ = 0.0, projected_near_vertical_area_ = 0.0;
};

}  // namespace moldlight
