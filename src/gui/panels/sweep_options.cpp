// The options of the sweep, unfolded in its panel.
#include <span>
#include <vector>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "gui/panels/table_bar.hpp"

namespace moldlight::gui {

void draw_sweep_options(const PanelContext& context) {
  // Most of them range over many powers of ten, some from 0 on.
  const RowOptions numbers = typed_numbers(context);
  SweepSettings& settings = context.edits.sweep_choices.options;
  // In a low window there is no room for what is seldom set.
  constexpr float k_low_window = 680.0F;
  const bool low = ImGui::GetIO().DisplaySize.y < context.ui.px(k_low_window);
  static const std::vector<Option<SweepSettings>> k_usual = [] {
    std::vector<Option<SweepSettings>> usual(sweep_options().begin(), sweep_options().end());
    std::erase_if(usual, [](const auto& option) { return option.key == "worth_pct"; });
    return usual;
  }();
  option_table<SweepSettings>(context.ui, low ? std::span(k_usual) : sweep_options(), settings, numbers);
  for (const Option<SweepSettings>& option : sweep_options()) {
    if (is_wide(option)) option_row(context.ui, option, settings, numbers);
  }
}

}  // namespace moldlight::gui
