// The options of the sweep, straight from its table.
#pragma once

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

void draw_sweep_options(const PanelContext& context);

}  // namespace moldlight::gui
