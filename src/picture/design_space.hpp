// Drawing a page that is designed for one size and scaled to others.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "picture/canvas.hpp"

namespace moldlight {

/// The background of a page.
[[nodiscard]] Colour picture_ground(bool dark);

/// The colours that text and boxes on a picture take.
struct PictureInks {
  Ink card, border, strong, normal, faint;
};
[[nodiscard]] PictureInks picture_inks(bool dark);

/// Places and lengths are those of the design; it stands in the middle of the canvas, as large as it can be.
class DesignSpace {
 public:
  /// `canvas` must outlive it.
  DesignSpace(Canvas& canvas, const glm::dvec2& design, bool dark);
  /// The same for a page that begins at `origin` of the canvas.
  DesignSpace(Canvas& canvas, const glm::dvec2& origin, double scale, bool dark);

  [[nodiscard]] Canvas& canvas() const { return canvas_; }
  [[nodiscard]] const PictureInks& inks() const { return inks_; }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] glm::dvec2 place(const glm::dvec2& at) const { return origin_ + scale_ * at; }
  [[nodiscard]] Box box(const glm::dvec2& corner, const glm::dvec2& size) const {
    return {place(corner), scale_ * size};
  }

  /// Styles are in pixels of the canvas.
  [[nodiscard]] TextStyle title() const;
  [[nodiscard]] TextStyle figure(Align align, FontWeight weight = FontWeight::regular) const;
  [[nodiscard]] TextStyle small(Align align) const;

  void text(const glm::dvec2& at, std::string_view words, const TextStyle& style) {
    canvas_.text(place(at), words, style);
  }
  /// The beginning of the words that fits into `width` of the design.
  void elided(const glm::dvec2& at, std::string_view words, const TextStyle& style, double width) {
    canvas_.text(place(at), canvas_.elided(words, style, scale_ * width), style);
  }
  /// The first of the texts that fits into `width`; of the last what fits.
  void fitting(const glm::dvec2& at, std::span<const std::string> texts, const TextStyle& style,
               double width);
  void line(const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, double width) {
    canvas_.line(place(from), place(to), ink, scale_ * width);
  }

 private:
  Canvas& canvas_;
  PictureInks inks_;
  double scale_;
  glm::dvec2 origin_;
};

}  // namespace moldlight
