// The window's own controls: one row each, name on the left and value on the right, no boxes in boxes. And
// what lies over the panels: dialogs, tooltips, and popups: menus, lists, options.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gui/draw/ui.hpp"

namespace moldlight::gui {

/// Height of a control, layout units.
inline constexpr float k_row_height = 24.0F;

/// What is clicked, or pressed with the keyboard.
struct Pressable {
  ScreenBox box = {};
  bool hovered = false, active = false;
  bool clicked = false;  // or pressed
  bool pressed = false;  // with the keyboard
  bool focused = false;  // has the keyboard; a ring shows it
};
/// An item of this size in pixels on which nothing is drawn yet. Recorded input finds it by its id.
Pressable pressable(const Ui& ui, const char* id, const glm::vec2& size);

/// Behind a value: as the mouse finds it.
[[nodiscard]] ImU32 field_colour(const Ui& ui, const Pressable& item);
/// `rounding` of the corners, pixels.
void fill(ImDrawList& list, const ScreenBox& box, ImU32 colour, float rounding);
/// Makes the item just drawn a control of this name.
void name_item(const Ui& ui, const std::string& name);

/// To be called for each other control, with its place: whether it has the keyboard, which a ring shows.
bool has_keyboard(const Ui& ui, std::string_view id, const ScreenBox& box);

/// A text that is typed. Empty it shows `hint`.
struct TextSpec {
  const char* hint = "";
  float width = 0.0F;   // pixels; 0: all there is
  bool starts = false;  // takes what is typed from now on
};
bool text_field(const Ui& ui, const char* id, std::span<char> text, const TextSpec& spec = {});

/// A row's name; that of a changed setting has a dot before it, which shows where a reset does something.
struct RowLabel {
  std::string_view text;
  bool modified = false;
};

/// A number on a bar that is dragged, or typed into after a double click or Ctrl+click.
struct SliderSpec {
  double min = 0.0, max = 1.0;
  double step = 0.0;                        // values of a drag are multiples of it; 0: any
  bool logarithmic = false;                 // min > 0
  std::function<double(double)> snap = {};  // to the round values that a drag stops at, in place of the step
  std::function<std::string(double)> text = {};  // as shown, unit included
};
bool slider(const Ui& ui, const RowLabel& label, double& value, const SliderSpec& spec);

/// A number that is typed.
struct NumberSpec {
  std::string_view label;
  int decimals;
  float width;             // pixels
  std::string unset = {};  // stands in place of 0
};
bool number_field(const Ui& ui, const char* id, double& value, const NumberSpec& spec);

bool toggle(const Ui& ui, const RowLabel& label, bool& on);

/// One of a few words, side by side.
bool choice(const Ui& ui, const RowLabel& label, std::span<const std::string_view> words, int& index);

struct ButtonSpec {
  float width = 0.0F;   // pixels; 0: as wide as the text
  bool strong = false;  // the one that Enter stands for
  bool chosen = false;
};
bool button(const Ui& ui, std::string_view label, const ButtonSpec& spec = {});

struct IconButtonSpec {
  const char* id;
  Icon icon;
  std::string_view tip;
  bool chosen = false;
};
bool icon_button(const Ui& ui, const IconButtonSpec& spec);

/// A switch as a small rounded word. Those after the first of a row stand beside it, or begin another line.
bool chip(const Ui& ui, std::string_view label, bool on, bool first = true);
/// Some of a few words, in their order.
bool chips(const Ui& ui, std::span<const std::string_view> words, std::vector<std::string_view>& chosen);
/// A quiet row that shows or hides more rows.
bool disclosure(const Ui& ui, std::string_view label, bool open);

/// A line of a menu; a click closes the menu.
struct MenuItemSpec {
  bool enabled = true;
  bool chosen = false;
};
bool menu_item(const Ui& ui, std::string_view label, const MenuItemSpec& spec = {});

/// A right click on the item just drawn, or what `asked` stands for, offers to copy a text.
void copy_menu(const Ui& ui, const char* id, const std::string& text, bool asked = false);

/// Words in lines that are no wider than so many pixels, the last with an ellipsis where there are more.
[[nodiscard]] std::vector<std::string> lines_within(const SizedFont& font, std::string_view text, float width,
                                                    std::size_t most);
/// Text in the small font and the muted colour, wrapped to the panel's width.
void hint(const Ui& ui, std::string_view text);
/// The same behind a sign of warning.
void warning(const Ui& ui, std::string_view text);
/// A text with its upper left corner at `at`, on a tag of its own: it reads on whatever lies below.
struct TaggedText {
  Lettering lettering;
  glm::vec2 at{0.0F};
  std::string_view text;
};
void draw_tagged_text(const Ui& ui, ImDrawList& list, const TaggedText& tagged);
/// A text as high as a control, `width` pixels wide.
void row_text(const Ui& ui, const Lettering& lettering, float width, std::string_view text);
/// A texture of the GL, whose rows begin below; nothing for 0.
void draw_picture(ImDrawList& list, unsigned texture, const ScreenBox& box, float rounding);

/// A word in the scene, behind the panels, on a tag that reads on any colour.
[[nodiscard]] glm::vec2 tag_size(const Ui& ui, std::string_view text);
void draw_tag(const Ui& ui, const glm::vec2& middle, std::string_view text, ImU32 colour);
/// The same where all of it is on the screen.
void draw_whole_tag(const Ui& ui, const glm::vec2& middle, std::string_view text, ImU32 colour);
/// Its middle where it stands beyond an arrow's tip.
[[nodiscard]] glm::vec2 beyond_tip(const Ui& ui, const glm::vec2& tail, const glm::vec2& tip,
                                   std::string_view text);

/// A thin bar from 0 to 1; less than 0: no share is known.
void progress_bar(const Ui& ui, double fraction, float width);

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
