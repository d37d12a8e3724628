// How something is drawn: ink, text styles, boxes.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "mold/region.hpp"

namespace moldlight {

struct Ink {
  Colour colour = {};
  double opacity = 1.0;  // [0, 1]
};

/// The families that all text is set in, the first that is installed.
inline constexpr const char* k_font_families[] = {"Inter", "Roboto", "Noto Sans", "DejaVu Sans"};

enum class FontWeight : std::uint8_t { regular, medium, semibold };
enum class Align : std::uint8_t { left, centre, right };

struct TextStyle {
  double size_px = 14.0;  // of the em square
  FontWeight weight = FontWeight::regular;
  Ink ink = {};
  Align align = Align::left;
  bool tabular = false;  // digits all of one width, for columns of figures
};

/// Pixels from the upper left corner, y down; a pixel's centre lies at half numbers.
struct Box {
  glm::dvec2 corner{0.0}, size{0.0};

  [[nodiscard]] glm::dvec2 far_corner() const { return corner + size; }
};

}  // namespace moldlight
