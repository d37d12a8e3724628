// Context that every panel draws with: scale, the system's sans-serif at exact pixel sizes with digits of one
// width, so that figures stand in columns, colours, icons, time.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <imgui.h>

#include "classify/number_format.hpp"
#include "gui/draw/keyboard.hpp"
#include "gui/store/user_state.hpp"
#include "mold/region.hpp"
#include "picture/font_files.hpp"

namespace moldlight::gui {

/// A font and the size to draw it at, in ImGui's measure (line height).
struct SizedFont {
  ImFont* font = nullptr;
  float size = 0.0F;
};

/// A font, and the colour that it is written in.
struct Lettering {
  SizedFont font;
  ImU32 colour = 0;
};

struct Fonts {
  SizedFont body, strong, small, title;
};

/// Fills the atlas for `scale` pixels per layout unit; ImGui's own font where the system has none. What the
/// atlas held is gone. `bytes` keeps the files' contents, which the atlas points to.
[[nodiscard]] Fonts load_fonts(ImFontAtlas& atlas, float scale, std::vector<std::string>& bytes);

/// Packed as ImGui packs them. Nothing here is saturated: colour belongs to the regions.
struct ThemeColours {
  ImU32 panel, panel_border, popup;          // behind text
  ImU32 text, muted;                         // text: figures and labels; units and hints
  ImU32 field, field_hovered, field_active;  // behind a value
  ImU32 fill, accent, on_accent;             // a slider's filled part, knobs and chosen words, text on them
  ImU32 line;                                // separators
  ImU32 scrim;                               // over the scene under a dialog
  ImU32 warning;
};

[[nodiscard]] const ThemeColours& theme_colours(Theme theme);

/// Sets every colour and length of ImGui's style; `scale` is pixels per layout unit.
void apply_style(Theme theme, float scale);

/// `alpha` times the colour's own.
[[nodiscard]] ImU32 faded(ImU32 colour, float alpha);
[[nodiscard]] ImU32 packed(const Colour& colour, float alpha = 1.0F);
[[nodiscard]] ImU32 mixed(ImU32 a, ImU32 b, float share_of_b);

/// Drawn as strokes, so that they are sharp at every scale and need no font.
enum class Icon : std::uint8_t {
  open,
  ruler,
  undo,
  redo,
  help,
  settings,
  flip,
  bookmark,
  chevron_down,
  chevron_up,
  chevron_left,
  chevron_right,
  close,
  check,
  alert,
  folder,
  file,
  up,
  sphere,
  revisions,
  exchange,
  eye,
};

/// Draws the icon into a square of `size` pixels around `centre`.
void draw_icon(ImDrawList& list, Icon icon, const glm::vec2& centre, float size, ImU32 colour);

/// A text as it was drawn in this frame: by these, layout and contrast are checked.
struct DrawnText {
  std::string text;
  std::string window;  // ImGui's name of the window that it belongs to
  ScreenBox box, clip;
  ImU32 colour = 0;
};

/// What the controls remember from one frame to the next.
struct UiMemory {
  ImGuiID typing_id = 0;  // the control into which a value is being typed
  std::array<char, 64> typed{};
  bool typing_starts = false;
  ImGuiID type_in = 0;  // the control that takes over
  Keyboard keyboard;
  Popups popups;
  std::string focused;         // name of the control that has the keyboard, as in `controls`
  bool scrim_clicked = false;  // beside the dialog that is open
  ImGuiID resting_on = 0;      // the item on which the mouse rests
  double resting_since_s = 0.0;
  double wake_s = std::numeric_limits<double>::infinity();  // when the next frame is wanted at the latest
  std::map<std::string, ScreenBox, std::less<>>
      controls;                  // of this frame, by label: recorded input finds them
  std::vector<DrawnText> texts;  // of this frame, in the order in which they were drawn
};

struct Ui {
  float scale = 1.0F;  // pixels per layout unit
  Fonts fonts;
  const ThemeColours* colours = nullptr;
  double now_s = 0.0;
  UiMemory* memory = nullptr;

  /// Whole pixels of a length in layout units.
  [[nodiscard]] float px(float units) const { return std::round(units * scale); }
  [[nodiscard]] Lettering text() const { return {fonts.body, colours->text}; }
  [[nodiscard]] Lettering muted() const { return {fonts.body, colours->muted}; }
  [[nodiscard]] Lettering strong() const { return {fonts.strong, colours->text}; }
  [[nodiscard]] Lettering small() const { return {fonts.small, colours->text}; }
  [[nodiscard]] Lettering note() const { return {fonts.small, colours->muted}; }
};

// Of the window that is open, pixels: where the next item goes, how wide it may be; what is drawn on it.
[[nodiscard]] inline glm::vec2 cursor_at() { return ImGui::GetCursorScreenPos(); }
inline void put_cursor(const glm::vec2& at) { ImGui::SetCursorScreenPos(at); }
[[nodiscard]] inline float room_left() { return ImGui::GetContentRegionAvail().x; }
[[nodiscard]] inline ImDrawList& window_list() { return *ImGui::GetWindowDrawList(); }
/// What is drawn on the scene, behind the panels.
[[nodiscard]] inline ImDrawList& scene_list() { return *ImGui::GetBackgroundDrawList(); }
[[nodiscard]] inline glm::vec2 mouse_at() { return ImGui::GetIO().MousePos; }
[[nodiscard]] inline glm::vec2 screen_size() { return ImGui::GetIO().DisplaySize; }
/// The window that is open; the item just drawn.
[[nodiscard]] inline ScreenBox window_box() {
  const glm::vec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  return {corner, corner + size};
}
[[nodiscard]] inline ScreenBox item_box() { return {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}; }

/// A GL texture as ImGui takes it.
[[nodiscard]] inline ImTextureID texture_id(unsigned name) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

/// Pictures of the shadow maps from +d and -d: GL textures, 0 for none.
struct MapTextures {
  unsigned plus = 0, minus = 0;
};

/// Pops the font when it goes out of scope.
class FontScope {
 public:
  explicit FontScope(const SizedFont& font) { ImGui::PushFont(font.font); }
  ~FontScope() { ImGui::PopFont(); }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;
};

/// Size of a text in a font, pixels.
[[nodiscard]] glm::vec2 text_size(const SizedFont& font, std::string_view text);
/// Remembers a text that was drawn by other means than the functions below.
void note_text(const ImDrawList& list, ImU32 colour, const ScreenBox& box, std::string_view text);
/// Draws a text with its upper left corner there.
void draw_text(ImDrawList& list, const Lettering& lettering, const glm::vec2& at, std::string_view text);
inline void draw_text(const Lettering& lettering, const glm::vec2& at, std::string_view text) {
  draw_text(window_list(), lettering, at, text);
}
/// As an item of the window that is open, in its present font; wrapped where that is asked for.
void draw_item_text(ImU32 colour, std::string_view text);
/// Into the window that is open, ending at `right`.
void draw_text_to(const Lettering& lettering, float right, float top, std::string_view text);
/// Text in the strong font.
void heading(const Ui& ui, std::string_view text);
/// Shortened to fit a width in pixels: of sentences, and of what stands between dots, as many whole ones as
/// there is room for; of anything else the middle is left out.
[[nodiscard]] std::string fitted(const SizedFont& font, std::string_view text, float width);

/// Flags of windows that are neither moved nor sized, and of those that are as large as what is in them.
inline constexpr ImGuiWindowFlags k_fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
inline constexpr ImGuiWindowFlags k_card_window =
    k_fixed_window | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
/// The next window's place: that of its point at `pivot`, which is a share of its size.
void place_window(const glm::vec2& at, const glm::vec2& pivot);

}  // namespace moldlight::gui
