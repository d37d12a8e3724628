// The help sheet and the window's settings.
#include <array>

#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

struct HelpLine {
  const char *keys, *meaning;
};

constexpr std::array k_direction_help = {
    HelpLine{"Drag the arrow's tip", "turn the parting direction"},
    HelpLine{"Ctrl while dragging", "snap to the part's own directions"},
    HelpLine{"Esc", "undo the drag"},
    HelpLine{"Double click", "direction: normal of that facet"},
    HelpLine{"Click", "choose the CAD face there (STEP)"},
    HelpLine{"Alt + double click", "direction: axis of that round wall"},
    HelpLine{"N / A", "the same for the facet under the cursor"},
    HelpLine{"Arrow keys", "turn by 1°, with Shift by 0.1°"},
    HelpLine{"X", "flip"},
    HelpLine{"B", "bookmark the direction"},
    HelpLine{"W", "sweep: find directions, or cancel"},
    HelpLine{"C", "compare with the best, the next …"},
    HelpLine{"M", "map of directions, large"},
};
constexpr std::array k_view_help = {
    HelpLine{"1 / 3 / 7", "front, right, top; with Ctrl the opposite"},
    HelpLine{"0", "along the parting direction"},
    HelpLine{"5", "parallel or perspective"},
    HelpLine{"F", "fit the part"},
    HelpLine{"O", "open or close the mold"},
    HelpLine{"S", "section plane"},
    HelpLine{"D", "colour by region or by draft angle"},
    HelpLine{"P", "palette"},
    HelpLine{"T", "dark or light"},
};
constexpr std::array k_program_help = {
    HelpLine{"Ctrl+O", "open a part"},
    HelpLine{"Ctrl+E", "export"},
    HelpLine{"F12", "picture with legend"},
    HelpLine{"Ctrl+Z / Ctrl+Y", "undo, redo"},
    HelpLine{"Tab", "hide the panels"},
    HelpLine{"H", "this sheet"},
    HelpLine{"Double click a value", "type it"},
    HelpLine{"Right click", "reset, copy"},
    HelpLine{"Ctrl+Q", "quit"},
};

std::array<HelpLine, 3> mouse_help(NavigationPreset preset) {
  switch (preset) {
    case NavigationPreset::solidworks:
      return {{{"Middle drag", "turn"}, {"Ctrl + middle drag", "shift"}, {"Wheel", "zoom to the cursor"}}};
    case NavigationPreset::fusion:
      return {{{"Shift + middle drag", "turn"}, {"Middle drag", "shift"}, {"Wheel", "zoom to the cursor"}}};
    case NavigationPreset::blender:
      return {{{"Middle drag", "turn"}, {"Shift + middle drag", "shift"}, {"Wheel", "zoom to the cursor"}}};
    case NavigationPreset::standard:
      break;
  }
  return {{{"Left drag", "turn"}, {"Right or middle drag", "shift"}, {"Wheel", "zoom to the cursor"}}};
}

void draw_lines(const Ui& ui, std::string_view heading, std::span<const HelpLine> lines) {
  {
    const FontScope strong(ui.fonts.strong);
    ImGui::TextUnformatted(heading.data(), heading.data() + heading.size());
  }
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  const float left = ImGui::GetCursorPosX();
  for (const HelpLine& line : lines) {
    ImGui::TextUnformatted(line.keys);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + ui.px(148));
    ImGui::PushStyleColor(ImGuiCol_Text, ui.colours->muted);
    ImGui::TextUnformatted(line.meaning);
    ImGui::PopStyleColor();
  }
  ImGui::Dummy(ImVec2(1, ui.px(10)));
}

bool clicked_outside() {
  return ImGui::IsMouseClicked(0) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                                             ImGuiHoveredFlags_AllowWhenBlockedByPopup |
                                                             ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

}  // namespace

void draw_help(const PanelContext& context) {
  if (!context.state.dialogs.help) return;
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Help", {0, 0})) {
    ImGui::BeginGroup();
    draw_lines(ui, "Direction", k_direction_help);
    draw_lines(ui, "Mouse", mouse_help(context.state.window.navigation));
    ImGui::EndGroup();
    ImGui::SameLine(0.0F, ui.px(40));
    ImGui::BeginGroup();
    draw_lines(ui, "View", k_view_help);
    draw_lines(ui, "Program", k_program_help);
    ImGui::EndGroup();
    if (clicked_outside()) context.edits.dialogs.help = false;
  }
  end_dialog();
}

void draw_settings(const PanelContext& context) {
  if (!context.state.dialogs.settings) return;
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Window settings", {ui.px(420), 0.0F})) {
    {
      const FontScope strong(ui.fonts.strong);
      ImGui::TextUnformatted("Window");
    }
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    for (const Option<WindowSettings>& option : window_options())
      option_row(ui, option, context.edits.window);
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    bool beside = context.state.notes_beside;
    if (context.state.model && toggle(ui, "Keep settings and bookmarks beside the part", beside, false)) {
      context.edits.ask(SaveNotesBeside{beside});
    }
    if (button(ui, "Put the panels back in place")) context.edits.ask(ResetLayout{});
    ImGui::SameLine();
    if (button(ui, "Close", {.width = 0.0F, .strong = true})) context.edits.dialogs.settings = false;
    if (clicked_outside() && ImGui::GetIO().MousePos.y > ui.px(k_bar_height))
      context.edits.dialogs.settings = false;
  }
  end_dialog();
}

}  // namespace moldlight::gui
