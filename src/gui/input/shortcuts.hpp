// What each key does.
#pragma once

#include "gui/app_state.hpp"
#include "gui/edits.hpp"
#include "gui/input/keys.hpp"

namespace moldlight::gui {

/// Whether a key ends the program, also while text is being typed.
[[nodiscard]] bool ends_program(const KeyPress& press);
/// Keys pressed while no text is being typed.
void apply_shortcut(const KeyPress& press, const AppState& state, Edits& edits);

}  // namespace moldlight::gui
