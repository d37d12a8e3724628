#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include "gui/draw/ui.hpp"
#include FT_FREETYPE_H
#include <imgui_freetype.h>

#include "picture/canvas.hpp"

namespace moldlight::gui {

namespace {

// Basic Latin to Latin Extended-B, Greek, Cyrillic, then the signs that the window writes.
constexpr ImWchar k_digits[] = {'0', '9', 0};
constexpr ImWchar k_text[] = {0x20,   0x2F,   0x3A,   0x24F,  0x370,  0x3FF,  0x400,  0x4FF,  0x2009,
                              0x2027, 0x2030, 0x203A, 0x2070, 0x209C, 0x20AC, 0x20AC, 0x2190, 0x2193,
                              0x2212, 0x2212, 0x221E, 0x221E, 0x2248, 0x2248, 0x2260, 0x2265, 0};

struct PatternDelete {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, PatternDelete>;

/// The installed face of this family that is nearest to the weight; an empty path where the family is not
/// there (fontconfig would give another one).
FontFile find_face(const char* family, int weight) {
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
  for (int i = 0; FcPatternGetString(found.get(), FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    same_family = same_family || std::strcmp(reinterpret_cast<const char*>(name), family) == 0;
  }
  if (!same_family || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  if (FcPatternGetInteger(found.get(), FC_INDEX, 0, &face) != FcResultMatch) face = 0;
  return {reinterpret_cast<const char*>(file), face};
}

/// Measures of a face at a size in pixels per em.
struct FaceMeasure {
  float line_height = 0.0F;  // from ascender to descender
  float digit_width = 0.0F;  // of the widest digit
};

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

std::string read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

ImFontConfig config_for(const FontFile& file, const ImWchar* ranges) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.FontNo = file.face;
  config.GlyphRanges = ranges;
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  return config;
}

SizedFont add_font(ImFontAtlas& atlas, const FontFile& file, std::string& bytes, std::string& symbols,
                   float em_px) {
  const FaceMeasure measure = measure_face(bytes, file.face, em_px);
  if (measure.line_height <= 0.0F) return {};
  const float size = std::round(measure.line_height);
  const auto add = [&](std::string& data, ImFontConfig config) {
    return atlas.AddFontFromMemoryTTF(data.data(), static_cast<int>(data.size()), size, &config);
  };
  ImFontConfig digits = config_for(file, k_digits);
  digits.GlyphMinAdvanceX = digits.GlyphMaxAdvanceX = std::round(measure.digit_width);
  ImFont* font = add(bytes, digits);
  ImFontConfig text = config_for(file, k_text);
  text.MergeMode = true;
  add(bytes, text);
  if (!symbols.empty()) {
    ImFontConfig more = config_for({}, k_text);
    more.MergeMode = true;
    add(symbols, more);
  }
  return {font, size};
}

/// ImGui's builder rounds every advance up, which spaces small text out; the nearest whole pixel keeps it
/// sharp and as wide as it should be.
void round_advances(ImFont& font) {
  FT_Library library = nullptr;
  if (font.ConfigDataCount == 0 || FT_Init_FreeType(&library) != 0) return;
  for (int k = 0; k < font.ConfigDataCount; ++k) {
    const ImFontConfig& config = font.ConfigData[k];
    FT_Face face = nullptr;
    if (config.GlyphRanges == k_digits ||
        FT_New_Memory_Face(library, static_cast<const FT_Byte*>(config.FontData), config.FontDataSize,
                           config.FontNo, &face) != 0) {
      continue;
    }
    const float per_unit = config.SizePixels / static_cast<float>(face->ascender - face->descender);
    for (ImFontGlyph& glyph : font.Glyphs) {
      const bool digit = glyph.Codepoint >= '0' && glyph.Codepoint <= '9';
      if (digit || FT_Get_Char_Index(face, glyph.Codepoint) == 0 ||
          FT_Load_Char(face, glyph.Codepoint, FT_LOAD_NO_SCALE) != 0) {
        continue;
      }
      glyph.AdvanceX = std::round(static_cast<float>(face->glyph->metrics.horiAdvance) * per_unit);
      font.IndexAdvanceX[static_cast<int>(glyph.Codepoint)] = glyph.AdvanceX;
    }
    FT_Done_Face(face);
    break;  // what the symbol font adds may stay as it is
  }
  FT_Done_FreeType(library);
}

}  // namespace

FontFile find_interface_font(bool semibold) {
  for (const char* family : k_font_families) {
    const FontFile file = find_face(family, semibold ? FC_WEIGHT_DEMIBOLD : FC_WEIGHT_REGULAR);
    if (!file.path.empty()) return file;
  }
  return {};
}

FontFile find_symbol_font() { return find_face("DejaVu Sans", FC_WEIGHT_REGULAR); }

Fonts load_fonts(ImFontAtlas& atlas, float scale, std::vector<std::string>& bytes) {
  atlas.Clear();
  const FontFile regular = find_interface_font(false), semibold = find_interface_font(true);
  bytes = {read_file(regular.path), read_file(semibold.path), read_file(find_symbol_font().path)};
  Fonts fonts;
  if (!bytes[0].empty() && !bytes[1].empty()) {
    fonts.body = add_font(atlas, regular, bytes[0], bytes[2], 13.0F * scale);
    fonts.strong = add_font(atlas, semibold, bytes[1], bytes[2], 13.0F * scale);
    fonts.small = add_font(atlas, regular, bytes[0], bytes[2], 11.0F * scale);
    fonts.title = add_font(atlas, semibold, bytes[1], bytes[2], 24.0F * scale);
  }
  if (fonts.title.font == nullptr) {
    atlas.Clear();
    ImFontConfig config;
    config.SizePixels = std::round(13.0F * scale);
    ImFont* font = atlas.AddFontDefault(&config);
    fonts.body = fonts.strong = fonts.small = fonts.title = {font, config.SizePixels};
  }
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.Build();
  for (const SizedFont& font : {fonts.body, fonts.strong, fonts.small, fonts.title})
    round_advances(*font.font);
  return fonts;
}

}  // namespace moldlight::gui
