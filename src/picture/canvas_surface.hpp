// What a Canvas draws on: pixels, or the pages of a document.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <cairo.h>
#include <glm/gtc/constants.hpp>

#include "base/utf8.hpp"
#include "picture/letters.hpp"
#include "picture/strokes.hpp"

namespace moldlight {

/// Whether Unicode may give the letter a meaning: Cairo refuses text with others, and all that follows.
constexpr bool is_assigned(char32_t letter) {
  return (letter & 0xFFFE) != 0xFFFE && (letter < 0xFDD0 || letter > 0xFDEF);
}

struct CanvasSurface {
  explicit CanvasSurface(cairo_surface_t* owned) : target(owned), cairo(cairo_create(owned)) {}
  ~CanvasSurface() {
    cairo_destroy(cairo);
    cairo_surface_destroy(target);
  }
  CanvasSurface(const CanvasSurface&) = delete;
  CanvasSurface& operator=(const CanvasSurface&) = delete;

  void set(const Ink& ink) const {
    cairo_set_source_rgba(cairo, ink.colour.r / 255.0, ink.colour.g / 255.0, ink.colour.b / 255.0,
                          ink.opacity);
  }
  void box_path(const Box& box, double radius) const {
    const glm::dvec2 low = box.corner, high = box.far_corner();
    const double r = std::min({radius, 0.5 * box.size.x, 0.5 * box.size.y});
    const double quarter = glm::half_pi<double>();
    cairo_new_path(cairo);
    cairo_arc(cairo, high.x - r, low.y + r, r, -quarter, 0.0);
    cairo_arc(cairo, high.x - r, high.y - r, r, 0.0, quarter);
    cairo_arc(cairo, low.x + r, high.y - r, r, quarter, 2.0 * quarter);
    cairo_arc(cairo, low.x + r, low.y + r, r, 2.0 * quarter, 3.0 * quarter);
    cairo_close_path(cairo);
  }
  void circle_path(const glm::dvec2& centre, double radius) const {
    cairo_new_path(cairo);
    cairo_arc(cairo, centre.x, centre.y, radius, 0.0, glm::two_pi<double>());
  }
  /// A glyph that stays a letter, for what keeps text as text.
  void show(const cairo_glyph_t& glyph, char32_t letter) const {
    const std::string utf8 = utf8_of(std::u32string(1, is_assigned(letter) ? letter : U'\uFFFD'));
    const cairo_text_cluster_t cluster{static_cast<int>(utf8.size()), 1};
    cairo_show_text_glyphs(cairo, utf8.data(), cluster.num_bytes, &glyph, 1, &cluster, 1,
                           cairo_text_cluster_flags_t{});
  }
  [[nodiscard]] std::vector<SetLetter> set_text(std::string_view text, const TextStyle& style) {
    return letters.set(text, style.size_px, style.weight, style.tabular);
  }

  cairo_surface_t* target;
  cairo_t* cairo;
  LetterSetter letters;
};

}  // namespace moldlight
