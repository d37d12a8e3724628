// The pages of a PDF, drawn on as pictures are (Cairo): text stays text that can be searched and copied, and
// its fonts are embedded.
#pragma once

#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "picture/canvas.hpp"

namespace moldlight {

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
