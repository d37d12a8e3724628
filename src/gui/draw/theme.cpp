#include <utility>

#include "gui/draw/ui.hpp"

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

}  // namespace moldlight::gui
