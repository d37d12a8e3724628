// Where the regions in a window's pictures come from: shadow maps, coarse and quick, while the direction
// moves; the split mesh, or maps as the settings want them, once it rests.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "classify/classifier.hpp"
#include "mold/exact/split_mesh.hpp"
#include "mold/second_depth.hpp"
#include "render/view_geometry.hpp"
#include "render/view_mesh.hpp"

namespace moldlight {

/// The settings with maps of 1024 texels at most. The edge thickness stays the length that it is for the
/// settings' own maps, and the lateral tolerance too where the maps are fine enough for it. `diagonal` of the
/// part, model units.
[[nodiscard]] MethodSettings moving_method(const MethodSettings& settings, double diagonal);

/// The maps, and the split surface.
///
/// Where the GL draws on the processor, our own scan converter makes the maps that are wanted quickly, which
/// takes a fraction of the time.
class PictureMaps : PartMaps {
 public:
  using PartMaps::buffers, PartMaps::maps, PartMaps::PartMaps;

  /// Draws the maps. Throws UsageError for settings that make no sense, Error where the GL fails.
  void draw_moving(const Query& query);
  void draw_quickly(const Query& query);
  void draw_resting(const Query& query);

  /// Takes the exact regions, for pictures of a direction at rest; `view` is the part's.
  void take_split(const SplitMesh& split, const ViewGeometry& view, const Query& query);
  void drop_split() { split_.reset(); }

  /// What there is of the direction that was given last. Valid until the next call.
  [[nodiscard]] ViewSubject subject() const;

  /// Makes sure that the maps have depths, which pictures of the part do not need.
  void complete_depths();

 private:
  void scan(const Query& query);

  glm::dvec3 direction_{0.0, 0.0, 1.0}, split_direction_{0.0};
  std::optional<SplitSurface> split_;
  std::vector<glm::vec3> positions_;  // of the vertices, unit frame
  std::optional<SecondDepthMaps> scanned_;
  bool lacks_depths_ = false;
};

/// Pause after measuring for `took_s`, in seconds: frames keep four fifths of the time as long as figures
/// still come more than ten times a second, and half of it in any case.
[[nodiscard]] constexpr double figure_pause_s(double took_s) {
  constexpr double k_period_s = 0.085;
  return std::min(4.0 * took_s, std::max(k_period_s - took_s, took_s));
}

}  // namespace moldlight
