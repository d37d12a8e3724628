// PDFs as a reader sees them, by poppler's programs (poppler-utils).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.hpp"

namespace moldlight::test {

/// Whether poppler's programs are installed; the others below need them.
[[nodiscard]] bool has_pdf_reader();

/// A word of a page; lengths are in points from the page's upper left corner.
struct PdfWord {
  std::string text;
  glm::dvec2 low{0.0}, high{0.0};
};
struct PdfPage {
  glm::dvec2 size{0.0};
  std::vector<PdfWord> words;
};
[[nodiscard]] std::vector<PdfPage> pdf_pages(std::string_view pdf);

/// What pdfinfo says of it, and pdffonts.
[[nodiscard]] std::string pdf_info(std::string_view pdf);
[[nodiscard]] std::string pdf_fonts(std::string_view pdf);

/// Its pages as pictures, a pixel a point.
[[nodiscard]] std::vector<Image> pdf_pictures(std::string_view pdf);

}  // namespace moldlight::test
