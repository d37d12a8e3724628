// The floating panels' windows: placed by the layout, moved and collapsed by the user. Places are independent
// of the window's size and scale: a panel keeps its distance to the nearer edges.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gui/draw/ui.hpp"

namespace moldlight::gui {

/// Width of every panel and height of the bar on top, layout units.
inline constexpr float k_panel_width = 272.0F;
inline constexpr float k_bar_height = 40.0F;
inline constexpr float k_title_height = 28.0F;

/// Where a panel's upper left corner is: in layout units from the window's left or right edge and from its
/// top.
struct PanelPlace {
  std::string name;
  glm::vec2 offset{0.0F};  // from_right: distance of the panel's right edge from the window's
  bool from_right = false;
  bool collapsed = false;
};

/// The size in layout units for which imgui.ini is written.
inline constexpr glm::vec2 k_layout_size{1280.0F, 720.0F};

/// Pixels per layout unit in a window of this size, pixels, where `wanted` are asked for: fewer, in
/// sixteenths, where panels would not fit beside each other.
[[nodiscard]] float fitting_scale(const glm::ivec2& size, float wanted);

/// Places from text as in imgui.ini (written for k_layout_size); panels it does not name are left out.
[[nodiscard]] std::vector<PanelPlace> parse_layout(std::string_view ini, float panel_width);
[[nodiscard]] std::string layout_text(const std::vector<PanelPlace>& places, float panel_width);

/// The layout that comes with the program.
[[nodiscard]] std::string_view shipped_layout();

/// The part of the window that panels leave free, pixels.
struct FreeArea {
  glm::ivec2 window{0};
  glm::ivec2 min{0}, max{0};

  [[nodiscard]] float middle_x() const { return 0.5F * static_cast<float>(min.x + max.x); }
  /// The upper left corner of a box that stands beside a point: to the right and below, or where there is
  /// room.
  [[nodiscard]] glm::vec2 beside(const glm::vec2& point, const glm::vec2& size, float gap) const;
  bool operator==(const FreeArea&) const = default;
};

/// Width that a table with sentences in it wants, layout units.
inline constexpr float k_wide_table = 1000.0F;

class PanelLayout {
 public:
  /// `ini` as imgui.ini; panels that it does not name get their place from the shipped one.
  explicit PanelLayout(std::string_view ini);

  /// `size` in pixels. Panels are put back in place when it or the scale changed.
  void begin_frame(const glm::ivec2& size, float scale);
  /// Begins the panel's window; false if there is nothing to draw in it. Call end() either way. `title`:
  /// where it is not the name, under which the place is kept.
  bool begin(const Ui& ui, const char* name, const char* title = nullptr);
  void end();
  /// The same for a panel along the bottom, between those on the sides or, where that is little, below them;
  /// above those that have been drawn there; it is as high as what is in it, and its first row is its title,
  /// which the panel draws. False if it is folded up to that row; then it is no wider than `folded_width`,
  /// pixels, where that is given. In a high window less than the `wanted` layout units is little, too.
  bool begin_bottom(const Ui& ui, const char* name, float folded_width = 0.0F, float wanted = 0.0F);
  /// Folds a panel along the bottom up, by its name, or down; then the others there are folded up: more than
  /// one would leave little of the part.
  void fold_bottom(std::string_view name, bool collapsed);
  /// Whether panels on the sides begin folded up to their titles, which is not remembered; a click opens one.
  void keep_sides_folded(bool folded) {
    pending_ = pending_ || folded != sides_folded_;
    sides_folded_ = folded;
  }
  /// What the panels left free when they were last drawn.
  [[nodiscard]] FreeArea free_area(bool panels_hidden) const;
  [[nodiscard]] std::string text() const;
  void reset() {
    panels_.clear();
    pending_ = true;
  }

 private:
  struct Panel {
    PanelPlace place;
    ScreenBox box = {};    // on the screen when last drawn, pixels
    glm::vec2 put{-1.0F};  // where it was put: it is elsewhere once the user has moved it
    bool drawn = false;
    bool collapsed = false;
    bool squeezed = false;  // for want of room, which is not remembered
    bool bottom = false;
    bool toggle = false;     // its chevron was clicked
    std::string title = {};  // that it has in this frame
  };
  void draw_title(const Ui& ui, Panel& each) const;
  /// Where it goes: its place, but in the window and below the panels that are above it in its column.
  [[nodiscard]] glm::vec2 corner_of(const Ui& ui, const Panel& each) const;
  /// Down to where a panel of the column at this x may reach, if it leaves room for the titles of those
  /// that have their place below `y` (layout units); the panel along the bottom may be under it, too.
  [[nodiscard]] float floor_at(const Ui& ui, float x, float y) const;
  Panel& panel(std::string_view name);

  std::vector<Panel> panels_;
  Panel* open_ = nullptr;
  glm::ivec2 size_{0};
  float scale_ = 0.0F;
  bool place_all_ = false, pending_ = true;  // this frame; the next one
  bool sides_folded_ = false;
};

}  // namespace moldlight::gui
