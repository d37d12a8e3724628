#include "picture/fonts.hpp"

#include <vector>

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>

#include "base/error.hpp"

namespace moldlight {

namespace {

int fontconfig_weight(FontWeight weight) {
  switch (weight) {
    case FontWeight::regular:
      return FC_WEIGHT_REGULAR;
    case FontWeight::medium:
      return FC_WEIGHT_MEDIUM;
    case FontWeight::semibold:
      break;
  }
  return FC_WEIGHT_SEMIBOLD;
}

const FcChar8* text(const char* ascii) { return reinterpret_cast<const FcChar8*>(ascii); }

}  // namespace

struct FontChain::Fonts {
  FcPattern* wanted = nullptr;
  FcFontSet* set = nullptr;
  std::vector<cairo_font_face_t*> faces;  // of the set, null until needed

  ~Fonts() {
    for (cairo_font_face_t* face : faces) {
      if (face != nullptr) cairo_font_face_destroy(face);
    }
    if (set != nullptr) FcFontSetDestroy(set);
    if (wanted != nullptr) FcPatternDestroy(wanted);
  }

  cairo_font_face_t* face(std::size_t index) {
    if (faces[index] == nullptr) {
      FcPattern* font = FcFontRenderPrepare(nullptr, wanted, set->fonts[index]);
      faces[index] = cairo_ft_font_face_create_for_pattern(font);
      FcPatternDestroy(font);
    }
    return faces[index];
  }
};

FontChain::FontChain(FontWeight weight) : fonts_(std::make_unique<Fonts>()) {
  fonts_->wanted = FcPatternCreate();
  for (const char* family : {"Inter", "Roboto", "Noto Sans", "DejaVu Sans", "sans-serif"}) {
    FcPatternAddString(fonts_->wanted, FC_FAMILY, text(family));
  }
  FcPatternAddInteger(fonts_->wanted, FC_WEIGHT, fontconfig_weight(weight));
  FcPatternAddBool(fonts_->wanted, FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, fonts_->wanted, FcMatchPattern);
  FcDefaultSubstitute(fonts_->wanted);
  FcResult result = FcResultNoMatch;
  fonts_->set = FcFontSort(nullptr, fonts_->wanted, FcTrue, nullptr, &result);
  if (fonts_->set == nullptr || fonts_->set->nfont == 0) {
    throw Error("no font is installed for the text of pictures: install one, such as fonts-dejavu-core");
  }
  fonts_->faces.resize(static_cast<std::size_t>(fonts_->set->nfont), nullptr);
}

FontChain::~FontChain() = default;

cairo_font_face_t* FontChain::face_with(char32_t letter) {
  for (std::size_t i = 0; i < fonts_->faces.size(); ++i) {
    FcCharSet* letters = nullptr;
    if (FcPatternGetCharSet(fonts_->set->fonts[i], FC_CHARSET, 0, &letters) != FcResultMatch) continue;
    if (FcCharSetHasChar(letters, letter) == FcTrue) return fonts_->face(i);
  }
  return fonts_->face(0);
}

}  // namespace moldlight
