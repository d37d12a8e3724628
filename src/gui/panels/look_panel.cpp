// What the picture shows: the mold's opening, section, colours, edges.
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

/// Switches that only add or remove something in the picture are chips; they flow over as many lines as they
/// need.
void draw_chips(const Ui& ui, LookSettings& look) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const Option<LookSettings>& option : look_options()) {
    const auto* kind = std::get_if<SwitchKind<LookSettings>>(&option.kind);
    if (kind == nullptr || option.key == "section") continue;
    const float width = text_size(ui.fonts.body, option.label).x + ui.px(18);
    if (!first) {
      ImGui::SameLine(0.0F, ui.px(4));
      if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    }
    first = false;
    bool& on = look.*(kind->member);
    if (chip(ui, option.label, on, width)) on = !on;
    tooltip(ui, option.label, option.help);
  }
}

}  // namespace

void draw_look_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Look")) {
    LookSettings& look = context.edits.settings.look;
    for (const Option<LookSettings>& option : look_options()) {
      const bool is_switch = std::holds_alternative<SwitchKind<LookSettings>>(option.kind);
      if (is_switch && option.key != "section") continue;
      if (option.key == "section_height" && !look.section) continue;
      option_row(ui, option, look);
      if (option.key == "open_mold" && ImGui::IsItemActive()) context.edits.dragging = true;
    }
    ImGui::Dummy(ImVec2(0.0F, ui.px(2)));
    draw_chips(ui, look);
  }
  context.layout.end();
}

}  // namespace moldlight::gui
