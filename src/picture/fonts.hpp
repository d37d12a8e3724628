// Fonts of pictures, found through fontconfig: Inter, Roboto, Noto Sans, DejaVu Sans, in this order, and what
// else the system has for letters that these lack.
#pragma once

#include <memory>

#include <cairo.h>

#include "picture/text_style.hpp"

namespace moldlight {

/// The fonts of one weight, the best first. Faces are loaded when they are first needed.
class FontChain {
 public:
  explicit FontChain(FontWeight weight);
  ~FontChain();
  FontChain(const FontChain&) = delete;
  FontChain& operator=(const FontChain&) = delete;

  /// The first face that has the letter; the best one if none does. Owned by the chain.
  [[nodiscard]] cairo_font_face_t* face_with(char32_t letter);

 private:
  struct Fonts;
  std::unique_ptr<Fonts> fonts_;
};

}  // namespace moldlight
