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
#include "mold/sweep/scan_kernel.hpp"
#include "mold/sweep/scan_part.hpp"

namespace moldlight {

struct ScanSettings {
  double tau_deg = 1.0;
  double edge_thickness = 2.0;  // width of the thick concave contour edges in texels
};

/// One thread's maps; drawing allocates nothing once the part is known.
class ScanMaps {
 public:
  /// `resolution` texels along a side, [16, 8192]; takes 32 bytes a texel.
  explicit ScanMaps(int resolution, const scan::Kernel& kernel = scan::best_kernel());

  void draw(const ScanPart& part, const MapFrame& frame, const ScanSettings& settings);

  /// Facet + 1 of the +d map (facets that face -d, furthest along +d) or of the -d map; 0 where there is
  /// none.
  [[nodiscard]] std::uint32_t entry(bool plus, int x, int y) const {
    const std::int64_t back = cell(plus ? scan::k_down_layer : scan::k_up_layer, x, y).back;
    return is_present(back) ? scan::facet_of(back) + 1 : 0;
  }

  /// What a texel holds of a layer.
  [[nodiscard]] const scan::MapCell& cell(scan::Layer layer, int x, int y) const {
    return target_.layer[layer][static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution_) +
                                static_cast<std::size_t>(x)];
  }
  /// False for an entry of a cell where no facet is.
  [[nodiscard]] bool is_present(std::int64_t entry) const {
    return scan::generation_of(entry) == target_.generation;
  }

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
  void classify(const ScanPart& part, double tau_deg);
  void draw_concave_edges(const ScanPart& part, double half_width);

  int resolution_;
  const scan::Kernel* kernel_;
  std::vector<scan::MapCell> cells_[2];
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
  std::size_t near_vertical_count_ = 0;
  double class_area_[3] = {}, projected_area_ = 0.0, projected_near_vertical_area_ = 0.0;
};

}  // namespace moldlight
