// Settings of the picture: section, colours, edges.
#include <utility>

#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

/// Switches that only add or remove something in the picture are chips.
void draw_chips(const Ui& ui, LookSettings& look) {
  bool first = true;
  for (const Option<LookSettings>& option : look_options()) {
    const auto* kind = std::get_if<SwitchKind<LookSettings>>(&option.kind);
    if (kind == nullptr || is_among(k_map_look_options, option)) continue;
    bool& on = look.*(kind->member);
    if (chip(ui, option.label, on, std::exchange(first, false))) on = !on;
    tooltip(ui, option.label, option.help);
  }
}

}  // namespace

void draw_look_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Look")) {
    LookSettings& look = context.edits.settings.look;
    const PartLengths lengths(context.state);
    for (const Option<LookSettings>& option : look_options()) {
      const bool is_switch = std::holds_alternative<SwitchKind<LookSettings>>(option.kind);
      if (is_switch || is_among(k_map_look_options, option) || option.key == "open_mold") continue;
      if (option.key == "section_at" && look.section == Section::off) continue;
      if (option.key == "section_turn" && look.section != Section::along) continue;
      option_row(ui, option, look, {.lengths = &lengths});
      if (option.key == "colouring" && look.colour_mode == ColourMode::draft_angle) draw_draft_key(context);
    }
    ImGui::Dummy(ImVec2(0.0F, ui.px(2)));
    draw_chips(ui, look);
  }
  context.layout.end();
}

}  // namespace moldlight::gui
