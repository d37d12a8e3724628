#include "picture/canvas.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

#include <cairo-pdf.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "picture/letters.hpp"

namespace moldlight {

namespace {

/// Whether Unicode may give the letter a meaning: Cairo refuses text with others, and all that follows.
constexpr bool is_assigned(char32_t letter) {
  return (letter & 0xFFFE) != 0xFFFE && (letter < 0xFDD0 || letter > 0xFDEF);
}

/// Cairo keeps pixels as native 32-bit words, alpha uppermost, colours multiplied by alpha.
std::uint32_t to_word(const std::uint8_t* rgba) {
  const auto multiplied = [alpha = rgba[3]](std::uint8_t channel) {
    return static_cast<std::uint32_t>((channel * alpha + 127) / 255);
  };
  return static_cast<std::uint32_t>(rgba[3]) << 24 | multiplied(rgba[0]) << 16 | multiplied(rgba[1]) << 8 |
         multiplied(rgba[2]);
}

void from_word(std::uint32_t word, std::uint8_t* rgba) {
  const std::uint32_t alpha = word >> 24;
  const auto straight = [alpha](std::uint32_t channel) {
    return alpha == 0 ? std::uint8_t{0}
                      : static_cast<std::uint8_t>(
                            std::min<std::uint32_t>(255, ((channel & 255) * 255 + alpha / 2) / alpha));
  };
  rgba[0] = straight(word >> 16);
  rgba[1] = straight(word >> 8);
  rgba[2] = straight(word);
  rgba[3] = static_cast<std::uint8_t>(alpha);
}

cairo_surface_t* surface_of(const Image& image) {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height);
  CHECK(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS);
  std::uint8_t* bytes = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t word = to_word(image.at(x, y));
      std::memcpy(bytes + y * stride + 4 * x, &word, 4);
    }
  }
  cairo_surface_mark_dirty(surface);
  return surface;
}

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

/// The surface that a Canvas draws on: pixels, or the pages of a document.
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

Canvas::Canvas(int width, int height) : Canvas(empty_image(width, height)) {}
Canvas::Canvas(const Image& image) : surface_(std::make_unique<CanvasSurface>(surface_of(image))) {}
Canvas::Canvas(std::unique_ptr<CanvasSurface> surface) : surface_(std::move(surface)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

glm::dvec2 Canvas::size() const {
  return {cairo_image_surface_get_width(surface_->target), cairo_image_surface_get_height(surface_->target)};
}

void Canvas::fill(const Ink& ink) {
  surface_->set(ink);
  cairo_paint(surface_->cairo);
}

void Canvas::fill_box(const Box& box, const Ink& ink, double radius) {
  surface_->set(ink);
  surface_->box_path(box, radius);
  cairo_fill(surface_->cairo);
}

void Canvas::outline_box(const Box& box, const Ink& ink, double radius, double width) {
  surface_->set(ink);
  surface_->box_path(box, radius);
  cairo_set_line_width(surface_->cairo, width);
  cairo_stroke(surface_->cairo);
}

void Canvas::hatch_box(const Box& box, const Ink& ink, double radius, double pitch) {
  cairo_t* cairo = surface_->cairo;
  cairo_save(cairo);
  surface_->box_path(box, radius);
  cairo_clip(cairo);
  surface_->set(ink);
  cairo_set_line_width(cairo, 0.42 * pitch);
  const double step = pitch * glm::root_two<double>();
  for (double x = box.corner.x; x < box.far_corner().x + box.size.y; x += step) {
    cairo_move_to(cairo, x + 1.0, box.corner.y - 1.0);
    cairo_line_to(cairo, x - box.size.y - 1.0, box.far_corner().y + 1.0);
  }
  cairo_stroke(cairo);
  cairo_restore(cairo);
}

void Canvas::line(const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, double width) {
  surface_->set(ink);
  cairo_set_line_cap(surface_->cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(surface_->cairo, width);
  cairo_move_to(surface_->cairo, from.x, from.y);
  cairo_line_to(surface_->cairo, to.x, to.y);
  cairo_stroke(surface_->cairo);
  cairo_set_line_cap(surface_->cairo, CAIRO_LINE_CAP_BUTT);
}

void Canvas::arrow(const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, double width) {
  const double length = glm::distance(from, to);
  if (length < 1e-6) return;
  const glm::dvec2 along = (to - from) / length, aside(-along.y, along.x);
  const double head = std::min(5.0 * width, length);
  line(from, to - 0.8 * head * along, ink, width);
  cairo_new_path(surface_->cairo);
  for (const glm::dvec2& corner :
       {to, to - head * along + 0.38 * head * aside, to - head * along - 0.38 * head * aside}) {
    cairo_line_to(surface_->cairo, corner.x, corner.y);
  }
  cairo_close_path(surface_->cairo);
  surface_->set(ink);
  cairo_fill(surface_->cairo);
}

void Canvas::disc(const glm::dvec2& centre, double radius, const Ink& ink) {
  surface_->set(ink);
  surface_->circle_path(centre, radius);
  cairo_fill(surface_->cairo);
}

void Canvas::ring(const glm::dvec2& centre, double radius, const Ink& ink, double width) {
  surface_->set(ink);
  surface_->circle_path(centre, radius);
  cairo_set_line_width(surface_->cairo, width);
  cairo_stroke(surface_->cairo);
}

void Canvas::picture(const Image& image, const Box& box) {
  if (image.width == 0 || image.height == 0) return;
  cairo_t* cairo = surface_->cairo;
  cairo_surface_t* source = surface_of(image);
  cairo_save(cairo);
  cairo_translate(cairo, box.corner.x, box.corner.y);
  cairo_scale(cairo, box.size.x / image.width, box.size.y / image.height);
  cairo_set_source_surface(cairo, source, 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
  cairo_rectangle(cairo, 0.0, 0.0, image.width, image.height);
  cairo_fill(cairo);
  cairo_restore(cairo);
  cairo_surface_destroy(source);
}

void Canvas::text(const glm::dvec2& at, std::string_view text, const TextStyle& style) {
  const std::vector<SetLetter> letters = surface_->set_text(text, style);
  const double width = letters.empty() ? 0.0 : letters.back().end;
  const double start = style.align == Align::left     ? at.x
                       : style.align == Align::centre ? at.x - 0.5 * width
                                                      : at.x - width;
  surface_->set(style.ink);
  const std::u32string spelled =
      cairo_surface_has_show_text_glyphs(surface_->target) != 0 ? letters_of(text) : std::u32string();
  for (std::size_t k = 0; k < letters.size(); ++k) {
    cairo_set_scaled_font(surface_->cairo, letters[k].font);
    const cairo_glyph_t glyph{letters[k].glyph, start + letters[k].start, at.y};
    spelled.empty() ? cairo_show_glyphs(surface_->cairo, &glyph, 1) : surface_->show(glyph, spelled[k]);
  }
}

double Canvas::text_width(std::string_view text, const TextStyle& style) {
  const std::vector<SetLetter> letters = surface_->set_text(text, style);
  return letters.empty() ? 0.0 : letters.back().end;
}

std::string Canvas::elided(std::string_view text, const TextStyle& style, double width) {
  if (text_width(text, style) <= width) return std::string(text);
  const std::u32string letters = letters_of(text);
  const auto shortened = [&](std::size_t kept) {
    const std::size_t tail = kept / 2, head = kept - tail;
    return utf8_of(letters.substr(0, head)) + "…" + utf8_of(letters.substr(letters.size() - tail));
  };
  // Of what fits and what does not, halved until they are one letter apart.
  std::size_t fits = 0, too_many = letters.size();
  while (too_many - fits > 1) {
    const std::size_t kept = (fits + too_many) / 2;
    (text_width(shortened(kept), style) <= width ? fits : too_many) = kept;
  }
  return shortened(fits);
}

Image Canvas::image() const {
  cairo_surface_flush(surface_->target);
  Image image = empty_image(cairo_image_surface_get_width(surface_->target),
                            cairo_image_surface_get_height(surface_->target));
  const std::uint8_t* bytes = cairo_image_surface_get_data(surface_->target);
  const int stride = cairo_image_surface_get_stride(surface_->target);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, bytes + y * stride + 4 * x, 4);
      from_word(word, image.at(x, y));
    }
  }
  return image;
}

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
