// The figures of two directions that are seen side by side, and their difference.
#pragma once

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// What the table takes of the window's upper part, layout units.
inline constexpr float k_comparison_height = 164.0F;

void draw_comparison(const PanelContext& context);

}  // namespace moldlight::gui
