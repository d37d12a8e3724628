// Drawing on pictures, and on the pages of a PDF: boxes, lines, arrows and text (Cairo).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "picture/strokes.hpp"

namespace moldlight {

struct CanvasSurface;

class Canvas {
 public:
  /// A transparent canvas.
  Canvas(int width, int height);
  /// A canvas with this picture on it.
  explicit Canvas(const Image& image);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  /// Of a picture; zero for pages.
  [[nodiscard]] glm::dvec2 size() const;

  void fill(const Ink& ink);
  void fill_box(const Box& box, const Ink& ink, double radius = 0.0);
  void outline_box(const Box& box, const Ink& ink, double radius, double width);
  /// Slanting stripes within a box, as undercuts have them.
  void hatch_box(const Box& box, const Ink& ink, double radius, double pitch);
  void line(const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, double width);
  /// A line with a filled head at `to`.
  void arrow(const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, double width);
  void disc(const glm::dvec2& centre, double radius, const Ink& ink);
  void ring(const glm::dvec2& centre, double radius, const Ink& ink, double width);
  /// A picture with its upper left corner at `corner`, scaled to `size`.
  void picture(const Image& image, const Box& box);

  /// One line of UTF-8 text; `at` is where its baseline starts, or its middle or end as aligned.
  void text(const glm::dvec2& at, std::string_view text, const TextStyle& style);
  [[nodiscard]] double text_width(std::string_view text, const TextStyle& style);
  /// The text, or what fits into `width` of it with an ellipsis in its middle.
  [[nodiscard]] std::string elided(std::string_view text, const TextStyle& style, double width);

  /// Of what is no page.
  [[nodiscard]] Image image() const;

 private:
  friend class PdfPages;
  explicit Canvas(std::unique_ptr<CanvasSurface> surface);

  std::unique_ptr<CanvasSurface> surface_;
};

class PdfPages {
 public:
  /// Begins with the first page; `size_pt` is that of all pages, in points of 1/72 inch.
  PdfPages(const glm::dvec2& size_pt, std::string_view title);
  PdfPages(const PdfPages&) = delete;
  PdfPages& operator=(const PdfPages&) = delete;

  /// The page at hand: lengths are points from its upper left corner, y down.
  [[nodiscard]] Canvas& page() { return canvas_; }
  void next_page();
  /// A line of the document's outline, which leads to `top_pt` of the page at hand.
  void outline(std::string_view title, double top_pt);

  /// The document; the same bytes wherever and whenever the same is drawn with the same fonts. Call once,
  /// last. Throws Error where it cannot be made.
  [[nodiscard]] std::string finish();

 private:
  std::string bytes_;
  Canvas canvas_;
  int number_ = 1;
};

}  // namespace moldlight
