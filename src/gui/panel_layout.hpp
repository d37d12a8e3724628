// The floating panels' windows: placed by the layout, moved and collapsed by the user.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gui/store/layout.hpp"
#include "gui/ui.hpp"
#include "gui/view_mapping.hpp"

namespace moldlight::gui {

/// Width of every panel and height of the bar on top, layout units.
inline constexpr float k_panel_width = 272.0F;
inline constexpr float k_bar_height = 40.0F;
inline constexpr float k_title_height = 28.0F;

class PanelLayout {
 public:
  /// `ini` as imgui.ini; panels that it does not name get their place from the shipped one.
  explicit PanelLayout(std::string_view ini);

  /// `size` in pixels. Panels are put back in place when it or the scale changed.
  void begin_frame(const glm::ivec2& size, float scale);
  /// Begins the panel's window; false if there is nothing to draw in it. Call end() either way.
  bool begin(const Ui& ui, const char* name);
  void end();
  /// The same for a panel along the bottom, between those on the sides; it is as high as what is in it, and
  /// its first row is its title, which the panel draws. False if it is folded up to that row.
  bool begin_bottom(const Ui& ui, const char* name);
  /// Folds the panel that is open up or down from the next frame on.
  void fold(bool collapsed);

  /// What the panels left free when they were last drawn.
  [[nodiscard]] FreeArea free_area(bool panels_hidden) const;
  [[nodiscard]] std::string text() const;
  void reset();

 private:
  struct Panel {
    PanelPlace place;
    glm::vec2 min{0.0F}, max{0.0F};  // on the screen when last drawn, pixels
    bool drawn = false;
    bool bottom = false;
    bool toggle = false;  // its chevron was clicked
  };
  void draw_title(const Ui& ui, Panel& each) const;
  Panel& panel(std::string_view name);

  std::vector<Panel> panels_;
  Panel* open_ = nullptr;
  glm::ivec2 size_{0};
  float scale_ = 0.0F;
  bool place_all_ = false, pending_ = true;  // this frame; the next one
};

}  // namespace moldlight::gui
