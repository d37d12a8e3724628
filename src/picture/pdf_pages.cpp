#include "picture/pdf_pages.hpp"

#include <algorithm>

#include <cairo-pdf.h>
#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "base/utf8.hpp"
#include "picture/canvas_surface.hpp"

namespace moldlight {

namespace {

cairo_status_t append(void* bytes, const unsigned char* more, unsigned int count) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(more), count);
  return CAIRO_STATUS_SUCCESS;
}

/// UTF-8 that Cairo takes: without what would end a C string, or what it refuses.
std::string label(std::string_view text) {
  std::u32string letters = letters_of(shown_text(text));
  std::ranges::replace_if(
      letters, [](char32_t letter) { return !is_assigned(letter); }, U'\uFFFD');
  return utf8_of(letters);
}

cairo_surface_t* pdf_surface(std::string& bytes, const glm::dvec2& size_pt, std::string_view title) {
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, size_pt.x, size_pt.y);
  CHECK(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, label(title).c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "moldlight");
  // Cairo's is the time at which it is made, which would make every document another.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
  return surface;
}

}  // namespace

PdfPages::PdfPages(const glm::dvec2& size_pt, std::string_view title)
    : canvas_(std::make_unique<CanvasSurface>(pdf_surface(bytes_, size_pt, title))) {}

void PdfPages::next_page() {
  cairo_show_page(canvas_.surface_->cairo);
  ++number_;
}

void PdfPages::outline(std::string_view title, double top_pt) {
  // Its numbers are written with a point, whatever the locale.
  const std::string target = fmt::format("page={} pos=[0 {:.1f}]", number_, top_pt);
  cairo_pdf_surface_add_outline(canvas_.surface_->target, CAIRO_PDF_OUTLINE_ROOT, label(title).c_str(),
                                target.c_str(), cairo_pdf_outline_flags_t{});
}

std::string PdfPages::finish() {
  cairo_surface_finish(canvas_.surface_->target);
  for (const cairo_status_t status :
       {cairo_status(canvas_.surface_->cairo), cairo_surface_status(canvas_.surface_->target)}) {
    // A context whose surface is finished says so.
    if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
      throw Error(fmt::format("the PDF cannot be made: {}", cairo_status_to_string(status)));
  }
  return bytes_;
}

}  // namespace moldlight
