// Setting a line of text: which glyph of which font stands where.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <cairo.h>

#include "base/owned.hpp"
#include "picture/strokes.hpp"

namespace moldlight {

/// A glyph of a line, in pixels from the line's start.
struct SetLetter {
  cairo_scaled_font_t* font = nullptr;  // owned by the LetterSetter
  unsigned long glyph = 0;
  double start = 0.0;  // the glyph's origin
  double end = 0.0;    // where the next letter may start
};

class LetterSetter {
 public:
  LetterSetter();
  ~LetterSetter();

  /// Tabular digits all take the widest digit's room.
  [[nodiscard]] std::vector<SetLetter> set(std::string_view utf8, double size_px, FontWeight weight,
                                           bool tabular);

 private:
  class FontChain;
  struct Glyph {
    cairo_scaled_font_t* font = nullptr;
    unsigned long number = 0;
    double advance = 0.0;
  };
  [[nodiscard]] Glyph glyph(char32_t letter, double size_px, FontWeight weight);

  std::array<std::unique_ptr<FontChain>, 3> chains_;  // by weight
  std::map<std::pair<cairo_font_face_t*, double>, Owned<cairo_scaled_font_t, cairo_scaled_font_destroy>>
      scaled_;
};

}  // namespace moldlight
