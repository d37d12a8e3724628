// What lies over the panels: dialogs, tooltips, and popups: menus, lists, options.
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

/// Opens a popup below the item just drawn, or at the mouse.
void open_popup_below_item(const Ui& ui, const char* id);
void open_popup_at_mouse(const Ui& ui, const char* id);
/// Begins the popup's window if it is open; call end_popup() then. `width` in pixels, 0: as wide as its
/// contents. Escape and a click elsewhere close it, and that click does what it does there.
[[nodiscard]] bool begin_popup(const Ui& ui, const char* id, float width = 0.0F);
void end_popup(const Ui& ui);

}  // namespace moldlight::gui
