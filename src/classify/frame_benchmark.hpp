// Frame times of the live view: the same camera path with plain shading, with exact regions while the
// direction rests, and with a direction that changes every frame while figures are measured beside it; and
// that direction while the camera rests, as it does while a hand drags the direction.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include <glm/vec2.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "classify/settings.hpp"
#include "gl/context.hpp"

namespace moldlight {

/// Medians over the path. Plain frames and those at rest take turns, and ratios are medians of the turns' own
/// ratios; those that change take turns with these in rounds. So what else the machine does falls on all
/// alike.
struct FrameTimes {
  std::size_t facets = 0;
  double plain_ms = 0.0, rest_ms = 0.0;
  double rest_ratio = 0.0;  // of frame rates to plain shading
  /// The direction changes.
  struct Changing {
    double ms = 0.0, ratio = 0.0;
    double figures_per_s = 0.0;  // areas of the regions, beside the frames
  };
  Changing changing, dragged;  // while the camera moves, and while it rests
};

/// Pictures as the window draws them while the camera moves, without its panels. `context` must be current.
/// Throws Error, Cancelled.
[[nodiscard]] FrameTimes measure_frames(const gl::Context& context,
                                        const std::shared_ptr<const PartModel>& model, const Query& asked,
                                        const glm::ivec2& size, const Progress& progress);

/// Four lines of name=value pairs: live_plain, live_rest, live_changing, live_dragged.
[[nodiscard]] std::string frame_times_text(const FrameTimes& times);

}  // namespace moldlight
