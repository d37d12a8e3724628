// The help sheet and the window's settings.
#include <vector>

#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

std::vector<HelpLine> mouse_help(NavigationPreset preset) {
  const auto lines = [](const char* turn, const char* shift) -> std::vector<HelpLine> {
    constexpr auto k_group = HelpLine::Group::view;
    return {{k_group, turn, "turn"}, {k_group, shift, "shift"}, {k_group, "Wheel", "zoom to the cursor"}};
  };
  switch (preset) {
    case NavigationPreset::solidworks:
      return lines("Middle drag", "Ctrl + middle drag");
    case NavigationPreset::fusion:
      return lines("Shift + middle drag", "Middle drag");
    case NavigationPreset::blender:
      return lines("Middle drag", "Shift + middle drag");
    case NavigationPreset::standard:
      break;
  }
  return lines("Left drag", "Right or middle drag");
}

void draw_lines(const Ui& ui, std::string_view title, const std::vector<HelpLine>& lines) {
  heading(ui, title);
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  const float left = ImGui::GetCursorPosX();
  for (const HelpLine& line : lines) {
    draw_item_text(ui.colours->text, line.keys);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + ui.px(148));
    draw_item_text(ui.colours->muted, line.meaning);
  }
  ImGui::Dummy(ImVec2(1, ui.px(10)));
}

}  // namespace

void draw_help(const PanelContext& context) {
  if (!context.state.dialogs.help) return;
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Help", {0, 0})) {
    ImGui::BeginGroup();
    draw_lines(ui, "Direction", help_lines(HelpLine::Group::direction));
    draw_lines(ui, "Mouse", mouse_help(context.state.window.navigation));
    ImGui::EndGroup();
    ImGui::SameLine(0.0F, ui.px(40));
    ImGui::BeginGroup();
    draw_lines(ui, "View", help_lines(HelpLine::Group::view));
    draw_lines(ui, "Program", help_lines(HelpLine::Group::program));
    ImGui::EndGroup();
  }
  if (end_dialog(ui)) context.edits.dialogs.help = false;
}

void draw_settings(const PanelContext& context) {
  if (!context.state.dialogs.settings) return;
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Window settings", {ui.px(420), 0.0F})) {
    heading(ui, "Window");
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    for (const Option<WindowSettings>& option : window_options())
      option_row(ui, option, context.edits.window);
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    bool beside = context.state.notes_beside;
    if (context.state.model && toggle(ui, {"Keep settings and bookmarks beside the part"}, beside)) {
      context.edits.ask(&Commands::save_notes_beside, beside);
    }
    if (button(ui, "Put the panels back in place")) context.edits.ask(&Commands::reset_layout);
    ImGui::SameLine();
    if (button(ui, "Close", {.width = 0.0F, .strong = true})) context.edits.dialogs.settings = false;
  }
  if (end_dialog(ui)) context.edits.dialogs.settings = false;
}

}  // namespace moldlight::gui
