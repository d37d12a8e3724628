// The options of the sweep, unfolded in its panel.
#include <algorithm>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

void draw_sweep_options(const PanelContext& context) {
  // Most of them range over many powers of ten, some from 0 on.
  const RowOptions numbers{
      .refused = [&](const std::string& why) { context.edits.ask(&Commands::say, why, true); }};
  SweepSettings& settings = context.edits.sweep_choices.options;
  option_table<SweepSettings>(context.ui, sweep_options(), settings, numbers);
  for (const Option<SweepSettings>& option : sweep_options()) {
    if (is_wide(option)) option_row(context.ui, option, settings, numbers);
  }
}

}  // namespace moldlight::gui
