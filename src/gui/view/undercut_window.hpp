// What would have to be open for the undercut that is looked at to need no side action, over the scene.
#pragma once

#include "gui/app_state.hpp"
#include "gui/draw/ui.hpp"

namespace moldlight::gui {

/// The change that makes the undercut free that is looked at; null for none, and while none is known.
[[nodiscard]] const ToBeFree* chosen_change(const AppState& state);

/// The outline of the window where it leaves the part, lines along the parting direction to the undercut, and
/// how large it is.
void draw_undercut_window(const Ui& ui, const AppState& state, const glm::ivec2& size);

}  // namespace moldlight::gui
