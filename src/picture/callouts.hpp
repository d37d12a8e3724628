// Numbers that point at places of a picture, and a bar that shows the scale, drawn on top of it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "picture/legend.hpp"

namespace moldlight {

/// A number and the place that it names, in pixels.
struct Callout {
  glm::dvec2 at{0.0};
  std::string text;
  bool hidden = false;  // behind surface: its place is a ring, not a dot
};

/// Each number in a disc of its own beside its place, away from `middle`, clear of the other discs and within
/// the picture.
void draw_callouts(Canvas& canvas, std::span<const Callout> callouts, const glm::dvec2& middle,
                   const LegendStyle& style);

/// A bar of 1, 2 or 5 times a power of ten in the lower right corner, a quarter of the picture's width at
/// most. `pixel_length`: length of a pixel in `unit`, > 0.
void draw_scale_bar(Canvas& canvas, double pixel_length, std::string_view unit, const LegendStyle& style);

}  // namespace moldlight
