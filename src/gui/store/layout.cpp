#include "gui/store/layout.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace moldlight::gui {

namespace {

/// A panel in imgui.ini as ImGui writes it: the position in pixels of a window of k_layout_size.
glm::vec2 parse_pair(std::string_view text) {
  glm::vec2 pair(0.0F);
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.x);
  if (first.ec == std::errc() && first.ptr != end) std::from_chars(first.ptr + 1, end, pair.y);
  return pair;
}

}  // namespace

std::vector<PanelPlace> parse_layout(std::string_view ini, float panel_width) {
  constexpr std::string_view k_heading = "[Window][", k_position = "Pos=", k_collapsed = "Collapsed=";
  std::vector<PanelPlace> places;
  bool in_window = false;
  while (!ini.empty()) {
    const std::size_t end = ini.find('\n');
    std::string_view line = ini.substr(0, end);
    ini.remove_prefix(end == std::string_view::npos ? ini.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('[')) {
      in_window = line.starts_with(k_heading) && line.ends_with(']');
      if (in_window) {
        line.remove_prefix(k_heading.size());
        line.remove_suffix(1);
        places.push_back({.name = std::string(line)});
      }
    } else if (in_window && line.starts_with(k_position)) {
      PanelPlace& place = places.back();
      place.offset = parse_pair(line.substr(k_position.size()));
      place.from_right = place.offset.x + 0.5F * panel_width > 0.5F * k_layout_size.x;
      if (place.from_right) place.offset.x = k_layout_size.x - panel_width - place.offset.x;
    } else if (in_window && line.starts_with(k_collapsed)) {
      places.back().collapsed = line.substr(k_collapsed.size()) == "1";
    }
  }
  return places;
}

std::string layout_text(const std::vector<PanelPlace>& places, float panel_width) {
  std::string text;
  for (const PanelPlace& place : places) {
    const float x = place.from_right ? k_layout_size.x - panel_width - place.offset.x : place.offset.x;
    text += fmt::format("[Window][{}]\nPos={:.0f},{:.0f}\nCollapsed={}\n\n", place.name, x, place.offset.y,
                        place.collapsed ? 1 : 0);
  }
  return text;
}

}  // namespace moldlight::gui
