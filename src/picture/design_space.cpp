#include "picture/design_space.hpp"

#include <algorithm>

namespace moldlight {

namespace {
constexpr double k_title_px = 24.0, k_figure_px = 15.0, k_small_px = 13.0;
}

Colour picture_ground(bool dark) { return dark ? Colour{27, 30, 34} : Colour{248, 249, 250}; }

DesignSpace::DesignSpace(Canvas& canvas, const glm::dvec2& design, bool dark)
    : canvas_(canvas),
      inks_(picture_inks(dark)),
      scale_(std::min(canvas.size().x / design.x, canvas.size().y / design.y)),
      origin_(0.5 * (canvas.size() - scale_ * design)) {}

DesignSpace::DesignSpace(Canvas& canvas, const glm::dvec2& origin, double scale, bool dark)
    : canvas_(canvas), inks_(picture_inks(dark)), scale_(scale), origin_(origin) {}

TextStyle DesignSpace::title() const {
  return {.size_px = k_title_px * scale_, .weight = FontWeight::semibold, .ink = inks_.strong};
}

TextStyle DesignSpace::figure(Align align, FontWeight weight) const {
  return {.size_px = k_figure_px * scale_,
          .weight = weight,
          .ink = weight == FontWeight::semibold ? inks_.strong : inks_.normal,
          .align = align,
          .tabular = true};
}

TextStyle DesignSpace::small(Align align) const {
  return {.size_px = k_small_px * scale_, .ink = inks_.faint, .align = align, .tabular = true};
}

void DesignSpace::text(const glm::dvec2& at, std::string_view words, const TextStyle& style) {
  canvas_.text(place(at), words, style);
}

void DesignSpace::elided(const glm::dvec2& at, std::string_view words, const TextStyle& style, double width) {
  canvas_.text(place(at), canvas_.elided(words, style, scale_ * width), style);
}

void DesignSpace::fitting(const glm::dvec2& at, std::span<const std::string> texts, const TextStyle& style,
                          double width) {
  for (const std::string& words : texts) {
    if (&words != &texts.back() && canvas_.text_width(words, style) > scale_ * width) continue;
    elided(at, words, style, width);
    return;
  }
}

void DesignSpace::line(const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, double width) {
  canvas_.line(place(from), place(to), ink, scale_ * width);
}

}  // namespace moldlight
