// What lies over the panels: dialogs and tooltips. Popups are in keyboard.hpp.
#pragma once

#include <string_view>

#include "gui/draw/ui.hpp"

namespace moldlight::gui {

/// A window in the middle of the screen over a scrim; `size` in pixels, 0: as wide or high as what is in it,
/// but not larger than the screen. Call end_dialog() either way; it is true where the dialog was left by a
/// click beside it.
bool begin_dialog(const Ui& ui, const char* name, const glm::vec2& size);
[[nodiscard]] bool end_dialog(const Ui& ui);

/// A tooltip for the item just drawn, shown when the mouse rests on it: a title (may be empty) and a
/// sentence.
void tooltip(const Ui& ui, std::string_view title, std::string_view text);
/// The same for what is drawn before end_tooltip(), which is called where this is true.
[[nodiscard]] bool begin_tooltip(const Ui& ui);
void end_tooltip();

}  // namespace moldlight::gui
