// How the window looks: its colours and its fonts.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include <ft2build.h>

#include "gui/draw/ui.hpp"
#include FT_FREETYPE_H
#include <imgui_freetype.h>

namespace moldlight::gui {

namespace {

constexpr ImU32 rgba(std::uint32_t rgb, int alpha = 255) {
  return IM_COL32((rgb >> 16) & 0xFF, (rgb >> 8) & 0xFF, rgb & 0xFF, alpha);
}

struct ColourRow {
  ImU32 ThemeColours::*member;
  ImU32 dark, light;
};
constexpr ColourRow k_colours[] = {
    {&ThemeColours::panel, rgba(0x1A1C1F, 240), rgba(0xFCFCFD, 238)},
    {&ThemeColours::panel_border, rgba(0xFFFFFF, 20), rgba(0x000000, 24)},
    {&ThemeColours::popup, rgba(0x202327, 250), rgba(0xFFFFFF, 252)},
    {&ThemeColours::text, rgba(0xE9EBEE), rgba(0x1B1D20)},
    {&ThemeColours::muted, rgba(0xB8BEC4), rgba(0x50565D)},
    {&ThemeColours::field, rgba(0xFFFFFF, 16), rgba(0x000000, 14)},
    {&ThemeColours::field_hovered, rgba(0xFFFFFF, 26), rgba(0x000000, 24)},
    {&ThemeColours::field_active, rgba(0xFFFFFF, 36), rgba(0x000000, 34)},
    {&ThemeColours::fill, rgba(0xFFFFFF, 34), rgba(0x000000, 28)},
    {&ThemeColours::accent, rgba(0xDADEE3), rgba(0x33373C)},
    {&ThemeColours::on_accent, rgba(0x16181A), rgba(0xFFFFFF)},
    {&ThemeColours::line, rgba(0xFFFFFF, 22), rgba(0x000000, 22)},
    {&ThemeColours::scrim, rgba(0x0C0D0E, 150), rgba(0xE8EAEC, 150)},
    {&ThemeColours::warning, rgba(0xE8C26A), rgba(0x9A6A00)},
};

ThemeColours made_colours(Theme theme) {
  ThemeColours colours{};
  for (const ColourRow& row : k_colours) colours.*row.member = theme == Theme::dark ? row.dark : row.light;
  return colours;
}

// Basic Latin to Latin Extended-B, Greek, Cyrillic, then the signs that the window writes.
constexpr ImWchar k_digits[] = {'0', '9', 0};
constexpr ImWchar k_text[] = {0x20,   0x2F,   0x3A,   0x24F,  0x370,  0x3FF,  0x400,  0x4FF,  0x2009,
                              0x2027, 0x2030, 0x203A, 0x2070, 0x209C, 0x20AC, 0x20AC, 0x2190, 0x2193,
                              0x2212, 0x2212, 0x221E, 0x221E, 0x2248, 0x2248, 0x2260, 0x2265, 0};

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

const ThemeColours& theme_colours(Theme theme) {
  static const ThemeColours k_dark = made_colours(Theme::dark), k_light = made_colours(Theme::light);
  return theme == Theme::dark ? k_dark : k_light;
}

ImU32 faded(ImU32 colour, float alpha) {
  const auto own = static_cast<float>((colour >> IM_COL32_A_SHIFT) & 0xFF);
  const auto scaled = static_cast<ImU32>(own * alpha + 0.5F);
  return (colour & ~IM_COL32_A_MASK) | (scaled << IM_COL32_A_SHIFT);
}

ImU32 packed(const Colour& colour, float alpha) {
  return IM_COL32(colour.r, colour.g, colour.b, static_cast<int>(alpha * 255.0F + 0.5F));
}

ImU32 mixed(ImU32 a, ImU32 b, float share_of_b) {
  ImU32 result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto from = static_cast<float>((a >> shift) & 0xFF), to = static_cast<float>((b >> shift) & 0xFF);
    result |= static_cast<ImU32>(from + (to - from) * share_of_b + 0.5F) << shift;
  }
  return result;
}

void apply_style(Theme theme, float scale) {
  const ThemeColours& c = theme_colours(theme);
  ImGuiStyle style;
  style.WindowPadding = ImVec2(12, 8);
  style.WindowRounding = 8;
  style.WindowBorderSize = 1;
  style.WindowMinSize = ImVec2(16, 16);
  style.WindowTitleAlign = ImVec2(0.0F, 0.5F);
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ChildRounding = 6;
  style.ChildBorderSize = 0;
  style.PopupRounding = 8;
  style.PopupBorderSize = 1;
  style.FramePadding = ImVec2(8, 4);
  style.FrameRounding = 6;
  style.FrameBorderSize = 0;
  style.ItemSpacing = ImVec2(6, 4);
  style.ItemInnerSpacing = ImVec2(8, 4);
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
  style.GrabRounding = 6;
  style.DisplaySafeAreaPadding = ImVec2(0, 0);
  style.ScaleAllSizes(scale);
  style.WindowBorderSize = style.PopupBorderSize = 1;
  style.AntiAliasedLinesUseTex = false;
  style.CircleTessellationMaxError = 0.2F;
  style.DisabledAlpha = 0.45F;

  constexpr ImU32 k_none = 0;
  const std::pair<ImGuiCol, ImU32> others[] = {
      {ImGuiCol_Text, c.text},
      {ImGuiCol_TextDisabled, c.muted},
      {ImGuiCol_WindowBg, c.panel},
      {ImGuiCol_ChildBg, k_none},
      {ImGuiCol_PopupBg, c.popup},
      {ImGuiCol_Border, c.panel_border},
      {ImGuiCol_BorderShadow, k_none},
      {ImGuiCol_FrameBgHovered, c.field_hovered},
      {ImGuiCol_FrameBgActive, c.field_active},
      {ImGuiCol_TitleBg, c.panel},
      {ImGuiCol_TitleBgActive, c.panel},
      {ImGuiCol_TitleBgCollapsed, c.panel},
      {ImGuiCol_ScrollbarBg, k_none},
      {ImGuiCol_ScrollbarGrab, c.field_hovered},
      {ImGuiCol_ScrollbarGrabHovered, c.field_active},
      {ImGuiCol_ScrollbarGrabActive, c.field_active},
      {ImGuiCol_CheckMark, c.accent},
      {ImGuiCol_ButtonHovered, c.field_hovered},
      {ImGuiCol_ButtonActive, c.field_active},
      {ImGuiCol_Header, c.field_hovered},
      {ImGuiCol_HeaderHovered, c.field_hovered},
      {ImGuiCol_HeaderActive, c.field_active},
      {ImGuiCol_Separator, c.line},
      {ImGuiCol_TextSelectedBg, faded(c.accent, 0.3F)},
      {ImGuiCol_ModalWindowDimBg, c.scrim},
      {ImGuiCol_NavHighlight, c.accent},
  };
  for (ImVec4& colour : style.Colors) colour = ImGui::ColorConvertU32ToFloat4(c.field);
  for (const auto& [index, colour] : others) style.Colors[index] = ImGui::ColorConvertU32ToFloat4(colour);
  ImGui::GetStyle() = style;
}

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
