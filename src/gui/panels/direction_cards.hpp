// Cards of recommended directions: a picture of the part along each, its verdict, what it wins and costs.
#pragma once

#include <span>

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// One below the other, as items of the window that is open; a click turns to one. `pictures`: a texture a
/// candidate of the sweep's result; 0, or too few of them, where there is none yet.
void draw_direction_cards(const PanelContext& context, std::span<const unsigned> pictures);

}  // namespace moldlight::gui
