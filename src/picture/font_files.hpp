// Which font files the system has for an interface, and how large their letters are.
#pragma once

#include <string>

namespace moldlight {

/// A face of a font file.
struct FontFile {
  std::string path;
  int face = 0;
};

/// The first of k_font_families (picture/strokes.hpp) that is installed, in a regular or a semibold weight
/// (or the nearest); an empty path where there is none.
[[nodiscard]] FontFile find_interface_font(bool semibold);
/// One with many symbols, for the characters that the first lacks; an empty path where there is none.
[[nodiscard]] FontFile find_symbol_font();

/// Measures of a face at a size in pixels per em.
struct FaceMeasure {
  float line_height = 0.0F;  // from ascender to descender
  float digit_width = 0.0F;  // of the widest digit
};
/// Of a font file's bytes; zero where they are none.
[[nodiscard]] FaceMeasure measure_face(const std::string& bytes, int face_index, float em_px);

}  // namespace moldlight
