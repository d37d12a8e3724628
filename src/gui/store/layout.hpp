// Places of the panels, independent of the window's size and scale: a panel keeps its distance to the nearer
// edges.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace moldlight::gui {

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

/// Places from text as in imgui.ini (written for k_layout_size); panels it does not name are left out.
[[nodiscard]] std::vector<PanelPlace> parse_layout(std::string_view ini, float panel_width);
[[nodiscard]] std::string layout_text(const std::vector<PanelPlace>& places, float panel_width);

/// The layout that comes with the program.
[[nodiscard]] std::string_view shipped_layout();

}  // namespace moldlight::gui
