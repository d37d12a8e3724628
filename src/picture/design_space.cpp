#include "picture/design_space.hpp"

#include <algorithm>

namespace moldlight {

namespace {
constexpr double k_title_px = 24.0, k_figure_px = 15.0, k_small_px = 13.0;
}

Colour picture_ground(bool dark) { return dark ? Colour{27, 30, 34} : Colour{248, 249, 250}; }

PictureInks picture_inks(bool dark) {
  if (dark) {
    return {.card = {{17, 19, 22}, 0.78},
            .border = {{255, 255, 255}, 0.09},
            .strong = {{244, 246, 248}},
            .normal = {{214, 218, 224}},
            .faint = {{146, 152, 162}}};
  }
  return {.card = {{255, 255, 255}, 0.86},
          .border = {{20, 30, 48}, 0.12},
          .strong = {{20, 24, 31}},
          .normal = {{52, 58, 68}},
          .faint = {{112, 120, 132}}};
}

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

void DesignSpace::fitting(const glm::dvec2& at, std::span<const std::string> texts, const TextStyle& style,
                          double width) {
  for (const std::string& words : texts) {
    if (&words != &texts.back() && canvas_.text_width(words, style) > scale_ * width) continue;
    elided(at, words, style, width);
    return;
  }
}

}  // namespace moldlight
