// Settings of the picture: section, colours, edges; and of steps' pictures the mold's opening and the key of
// the draft colours.
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/side_actions.hpp"
#include "render/view_settings.hpp"

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

void draw_draft_key(const PanelContext& context) {
  const Ui& ui = context.ui;
  const DraftScale scale =
      draft_scale(context.state.settings.required_draft.deg, context.state.settings.look.palette);
  const glm::vec2 start = cursor_at() + glm::vec2(ui.px(8), ui.px(3));
  const float step = (room_left() - ui.px(16)) / static_cast<float>(scale.colours.size());
  const float height = ui.px(8);
  ImDrawList& list = window_list();
  for (std::size_t k = 0; k < scale.colours.size(); ++k) {
    const glm::vec2 min = start + glm::vec2(static_cast<float>(k) * step, 0.0F);
    list.AddRectFilled(min, min + glm::vec2(step - ui.px(1), height), packed(scale.colours[k]), ui.px(2));
  }
  for (std::size_t k = 0; k < scale.limits_deg.size(); ++k) {
    const double limit = scale.limits_deg[k];
    const std::string text = fmt::format("{}{:.3g}°", limit < 0.0 ? "−" : "", std::abs(limit));
    draw_text(list, ui.note(),
              start + glm::vec2(static_cast<float>(k + 1) * step - 0.5F * text_size(ui.fonts.small, text).x,
                                height + ui.px(3)),
              text);
  }
  ImGui::Dummy(ImVec2(1.0F, height + ui.px(6) + ui.fonts.small.size));
}

void draw_opening(const PanelContext& context) {
  option_row(context.ui, option_named(look_options(), "open_mold"), context.edits.settings.look,
             {.text = [&](double open) { return opening_text(context.state, open); }});
  if (ImGui::IsItemActive()) context.edits.dragging = true;
}

void draw_look_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Look", "Section and look")) {
    LookSettings& look = context.edits.settings.look;
    const PartLengths lengths(context.state);
    for (const Option<LookSettings>& option : look_options()) {
      const bool is_switch = std::holds_alternative<SwitchKind<LookSettings>>(option.kind);
      // The mold's opening stands in its own step.
      if (is_switch || is_among(k_map_look_options, option) || option.key == "open_mold") continue;
      if (option.key == "section_at" && look.section == Section::off) continue;
      if (option.key == "section_turn" && look.section != Section::along) continue;
      option_row(ui, option, look, {.lengths = &lengths});
    }
    if (look.section != Section::off) hint(ui, "Point at the cut: it says how thick the wall is.");
    ImGui::Dummy(ImVec2(0.0F, ui.px(2)));
    draw_chips(ui, look);
  }
  context.layout.end();
}

}  // namespace moldlight::gui
