// The options of the sweep, unfolded in its panel.
#include <algorithm>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

void draw_sweep_options(const PanelContext& context) {
  constexpr float k_column = 210.0F;  // layout units, at least
  const int columns =
      std::max(1, static_cast<int>(ImGui::GetContentRegionAvail().x / context.ui.px(k_column)));
  // Most of them range over many powers of ten, some from 0 on.
  const RowOptions numbers{
      .refused = [&](const std::string& why) { context.edits.ask(&Commands::say, why, true); }};
  SweepSettings& settings = context.edits.sweep_choices.options;
  if (ImGui::BeginTable("options", columns,
                        ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings)) {
    for (const Option<SweepSettings>& option : sweep_options()) {
      if (!has_control(option) || is_wide(option)) continue;
      ImGui::TableNextColumn();
      option_row(context.ui, option, settings, numbers);
    }
    ImGui::EndTable();
  }
  for (const Option<SweepSettings>& option : sweep_options()) {
    if (is_wide(option)) option_row(context.ui, option, settings, numbers);
  }
}

}  // namespace moldlight::gui
