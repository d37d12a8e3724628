#include "picture/letters.hpp"

#include <algorithm>

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "picture/carried_fonts.hpp"

namespace moldlight {

namespace {

/// By FontWeight.
constexpr std::array k_fontconfig_weights = {FC_WEIGHT_REGULAR, FC_WEIGHT_MEDIUM, FC_WEIGHT_SEMIBOLD};

bool is_digit(char32_t letter) { return letter >= U'0' && letter <= U'9'; }

}  // namespace

/// The fonts of one weight, the best first, found through fontconfig: k_font_families in their order, and
/// what else the system has for letters that these lack. Faces are loaded when they are first needed.
class LetterSetter::FontChain {
 public:
  explicit FontChain(FontWeight weight);

  /// The first face that has the letter; the best one if none does. Owned by the chain.
  [[nodiscard]] cairo_font_face_t* face_with(char32_t letter);

 private:
  [[nodiscard]] cairo_font_face_t* face(std::size_t index);

  Owned<FcPattern, FcPatternDestroy> wanted_;
  Owned<FcFontSet, FcFontSetDestroy> set_;
  std::vector<Owned<cairo_font_face_t, cairo_font_face_destroy>> faces_;  // of the set, null until needed
};

LetterSetter::FontChain::FontChain(FontWeight weight) : wanted_(FcPatternCreate()) {
  find_carried_fonts();
  const auto add = [this](const char* family) {
    FcPatternAddString(wanted_.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  };
  for (const char* family : k_font_families) add(family);
  add("sans-serif");
  FcPatternAddInteger(wanted_.get(), FC_WEIGHT, k_fontconfig_weights[static_cast<std::size_t>(weight)]);
  FcPatternAddBool(wanted_.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, wanted_.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted_.get());
  FcResult result = FcResultNoMatch;
  set_.reset(FcFontSort(nullptr, wanted_.get(), FcTrue, nullptr, &result));
  if (set_ == nullptr || set_->nfont == 0)
    throw Error("no font is installed for the text of pictures: install one, such as fonts-dejavu-core");
  faces_.resize(static_cast<std::size_t>(set_->nfont));
}

cairo_font_face_t* LetterSetter::FontChain::face(std::size_t index) {
  if (faces_[index] == nullptr) {
    const Owned<FcPattern, FcPatternDestroy> font(
        FcFontRenderPrepare(nullptr, wanted_.get(), set_->fonts[index]));
    faces_[index].reset(cairo_ft_font_face_create_for_pattern(font.get()));
  }
  return faces_[index].get();
}

cairo_font_face_t* LetterSetter::FontChain::face_with(char32_t letter) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    FcCharSet* letters = nullptr;
    if (FcPatternGetCharSet(set_->fonts[i], FC_CHARSET, 0, &letters) != FcResultMatch) continue;
    if (FcCharSetHasChar(letters, letter) == FcTrue) return face(i);
  }
  return face(0);
}

LetterSetter::LetterSetter() = default;

LetterSetter::~LetterSetter() = default;

LetterSetter::Glyph LetterSetter::glyph(char32_t letter, double size_px, FontWeight weight) {
  auto& chain = chains_[static_cast<std::size_t>(weight)];
  if (!chain) chain = std::make_unique<FontChain>(weight);
  cairo_font_face_t* face = chain->face_with(letter);
  auto& font = scaled_[{face, size_px}];
  if (font == nullptr) {
    cairo_matrix_t size, identity;
    cairo_matrix_init_scale(&size, size_px, size_px);
    cairo_matrix_init_identity(&identity);
    const Owned<cairo_font_options_t, cairo_font_options_destroy> kept(cairo_font_options_create());
    cairo_font_options_t* const options = kept.get();
    // Neither hints nor whole pixels: letters then stand as drawn at every scale.
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    font.reset(cairo_scaled_font_create(face, &size, &identity, options));
    CHECK(cairo_scaled_font_status(font.get()) == CAIRO_STATUS_SUCCESS);
  }
  const std::string utf8 = utf8_of({&letter, 1});
  cairo_glyph_t* glyphs = nullptr;
  int count = 0;
  Glyph result{.font = font.get()};
  if (cairo_scaled_font_text_to_glyphs(font.get(), 0.0, 0.0, utf8.data(), static_cast<int>(utf8.size()),
                                       &glyphs, &count, nullptr, nullptr, nullptr) == CAIRO_STATUS_SUCCESS &&
      count > 0) {
    cairo_text_extents_t extents;
    cairo_scaled_font_glyph_extents(font.get(), glyphs, 1, &extents);
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
    for (char32_t digit = U'0'; digit <= U'9'; ++digit)
      widest_digit = std::max(widest_digit, glyph(digit, size_px, weight).advance);
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
