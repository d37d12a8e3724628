// The right half of the window when two directions are compared.
#pragma once

#include "gui/candidate_pictures.hpp"
#include "gui/ui.hpp"

namespace moldlight::gui {

/// Lays the picture of the other direction over the window's own, behind the panels. `texture` is drawn later
/// in the frame.
void draw_split(const Ui& ui, const SplitView& split, unsigned texture);

}  // namespace moldlight::gui
