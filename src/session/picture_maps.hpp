// The shadow maps behind pictures in a window: coarse and quick while the direction moves, fine once it
// rests.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gl/context.hpp"
#include "mold/scan/scan_maps.hpp"
#include "render/part_buffers.hpp"
#include "render/shadow_maps.hpp"
#include "session/part_model.hpp"
#include "session/settings.hpp"

namespace moldlight {

/// The settings with maps of 1024 texels at most. Lateral tolerance and edge thickness stay the lengths that
/// they are for the settings' own maps. `diagonal` of the part, model units.
[[nodiscard]] MethodSettings moving_method(const MethodSettings& settings, double diagonal);

/// Keeps one part's buffers and maps. `context` must be current at every call and outlive it.
///
/// Where the GL draws on the processor, our own scan converter makes the maps of a moving direction, which
/// takes a fraction of the time, and for a resting one whole facets are told apart once, so that pictures
/// from any side look up few of their fragments.
class PictureMaps {
 public:
  PictureMaps(const gl::Context& context, std::shared_ptr<const PartModel> model);

  /// Draws the maps of the settings' direction. Throws UsageError for settings that make no sense, Error
  /// where the GL fails.
  void draw_moving(const MethodSettings& settings);
  void draw_resting(const MethodSettings& settings);

  /// Makes sure that the maps have depths, which pictures of the part do not need.
  void complete_depths();

  [[nodiscard]] const PartBuffers& buffers() const { return buffers_; }
  [[nodiscard]] const ShadowMaps& maps() const { return maps_; }

 private:
  void scan(const MethodSettings& settings);

  const gl::Context* context_;
  std::shared_ptr<const PartModel> model_;
  PartBuffers buffers_;
  ShadowMaps maps_;
  std::unique_ptr<const ScanPart> scan_part_;
  std::optional<ScanMaps> scan_maps_;
  std::vector<std::uint32_t> plus_, minus_;  // facet + 1 a texel
  bool lacks_depths_ = false;
};

}  // namespace moldlight
