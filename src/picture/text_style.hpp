// How text on a picture looks.
#pragma once

#include <cstdint>

#include "mold/region.hpp"

namespace moldlight {

struct Ink {
  Colour colour = {};
  double opacity = 1.0;  // [0, 1]
};

enum class FontWeight : std::uint8_t { regular, medium, semibold };
enum class Align : std::uint8_t { left, centre, right };

struct TextStyle {
  double size_px = 14.0;  // of the em square
  FontWeight weight = FontWeight::regular;
  Ink ink = {};
  Align align = Align::left;
  bool tabular = false;  // digits all of one width, for columns of figures
};

}  // namespace moldlight
