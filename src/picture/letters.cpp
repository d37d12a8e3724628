#include "picture/letters.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "picture/utf8.hpp"

namespace moldlight {

namespace {

bool is_digit(char32_t letter) { return letter >= U'0' && letter <= U'9'; }

}  // namespace

LetterSetter::~LetterSetter() {
  for (const auto& [key, font] : scaled_) cairo_scaled_font_destroy(font);
}

LetterSetter::Glyph LetterSetter::glyph(char32_t letter, double size_px, FontWeight weight) {
  auto& chain = chains_[static_cast<std::size_t>(weight)];
  if (!chain) chain = std::make_unique<FontChain>(weight);
  cairo_font_face_t* face = chain->face_with(letter);
  auto& font = scaled_[{face, size_px}];
  if (font == nullptr) {
    cairo_matrix_t size, identity;
    cairo_matrix_init_scale(&size, size_px, size_px);
    cairo_matrix_init_identity(&identity);
    cairo_font_options_t* options = cairo_font_options_create();
    // Neither hints nor whole pixels: letters then stand as drawn at every scale.
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    font = cairo_scaled_font_create(face, &size, &identity, options);
    cairo_font_options_destroy(options);
    CHECK(cairo_scaled_font_status(font) == CAIRO_STATUS_SUCCESS);
  }
  const std::string utf8 = utf8_of({&letter, 1});
  cairo_glyph_t* glyphs = nullptr;
  int count = 0;
  Glyph result{.font = font};
  if (cairo_scaled_font_text_to_glyphs(font, 0.0, 0.0, utf8.data(), static_cast<int>(utf8.size()), &glyphs,
                                       &count, nullptr, nullptr, nullptr) == CAIRO_STATUS_SUCCESS &&
      count > 0) {
    cairo_text_extents_t extents;
    cairo_scaled_font_glyph_extents(font, glyphs, 1, &extents);
    result.number = glyphs[0].index;
    result.advance = extents.x_advance;
  }
  cairo_glyph_free(glyphs);
  return result;
}

std::vector<SetLetter> LetterSetter::set(std::string_view utf8, double size_px, FontWeight weight,
                                         bool tabular) {
  double widest_digit = 0.0;
  if (tabular) {
    for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
      widest_digit = std::max(widest_digit, glyph(digit, size_px, weight).advance);
    }
  }
  std::vector<SetLetter> letters;
  double at = 0.0;
  for (const char32_t letter : letters_of(utf8)) {
    const Glyph found = glyph(letter, size_px, weight);
    const double room = tabular && is_digit(letter) ? widest_digit : found.advance;
    letters.push_back({found.font, found.number, at + 0.5 * (room - found.advance), at + room});
    at += room;
  }
  return letters;
}

}  // namespace moldlight
