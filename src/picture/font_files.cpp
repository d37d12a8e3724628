#include "picture/font_files.hpp"

#include <algorithm>
#include <cstring>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include "base/owned.hpp"
#include "picture/canvas.hpp"
#include "picture/carried_fonts.hpp"

namespace moldlight {

namespace {

using Pattern = Owned<FcPattern, FcPatternDestroy>;

/// The installed face of this family that is nearest to the weight; an empty path where the family is not
/// there (fontconfig would give another one).
FontFile find_face(const char* family, int weight) {
  find_carried_fonts();
  Pattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight);
  FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(wanted.get(), FC_VARIABLE, FcFalse);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(nullptr, wanted.get(), &result));
  if (!found) return {};
  FcChar8* file = nullptr;
  int face = 0;
  bool same_family = false;
  FcChar8* name = nullptr;
  for (int i = 0; FcPatternGetString(found.get(), FC_FAMILY, i, &name) == FcResultMatch; ++i)
    same_family = same_family || std::strcmp(reinterpret_cast<const char*>(name), family) == 0;
  if (!same_family || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  if (FcPatternGetInteger(found.get(), FC_INDEX, 0, &face) != FcResultMatch) face = 0;
  return {reinterpret_cast<const char*>(file), face};
}

}  // namespace

FaceMeasure measure_face(const std::string& bytes, int face_index, float em_px) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return {};
  FaceMeasure measure;
  FT_Face face = nullptr;
  if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                         static_cast<FT_Long>(bytes.size()), face_index, &face) == 0) {
    const float per_unit = em_px / static_cast<float>(face->units_per_EM);
    measure.line_height = static_cast<float>(face->ascender - face->descender) * per_unit;
    for (FT_ULong digit = '0'; digit <= '9'; ++digit) {
      if (FT_Load_Char(face, digit, FT_LOAD_NO_SCALE) != 0) continue;
      measure.digit_width =
          std::max(measure.digit_width, static_cast<float>(face->glyph->metrics.horiAdvance) * per_unit);
    }
    FT_Done_Face(face);
  }
  FT_Done_FreeType(library);
  return measure;
}

FontFile find_interface_font(bool semibold) {
  for (const char* family : k_font_families) {
    const FontFile file = find_face(family, semibold ? FC_WEIGHT_DEMIBOLD : FC_WEIGHT_REGULAR);
    if (!file.path.empty()) return file;
  }
  return {};
}

FontFile find_symbol_font() { return find_face("DejaVu Sans", FC_WEIGHT_REGULAR); }

}  // namespace moldlight
