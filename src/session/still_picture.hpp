// The still picture of a classified part: what the window's viewport shows, with a legend.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "gl/context.hpp"
#include "render/view_settings.hpp"
#include "session/classifier.hpp"

namespace moldlight {

/// Automatic: with the parting direction upward, from where the undercuts are seen best. The others are the
/// views of the part's own axes, z up.
enum class PictureView : std::uint8_t { automatic, isometric, front, back, left, right, top, bottom };

inline constexpr int k_least_picture_px = 16, k_most_picture_px = 16384;  // along a side

struct StillSettings {
  glm::ivec2 size{1600, 1000};  // pixels, in that range each
  PictureView view = PictureView::automatic;
  Theme theme = Theme::light;
  Palette palette = Palette::paper;
  bool legend = true;  // left out where a picture is too small for it
  bool arrows = true;
};

/// Throws UsageError for a size out of range.
void validate(const StillSettings& settings);

/// Draws the maps for the classification's settings again, then the picture. `context` is the classifier's
/// and current.
[[nodiscard]] Image still_picture(const gl::Context& context, Classifier& classifier,
                                  const Classification& result, const StillSettings& settings);

}  // namespace moldlight
