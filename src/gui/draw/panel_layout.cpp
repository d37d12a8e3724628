#include "gui/draw/panel_layout.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/check.hpp"
#include "gui/draw/widgets.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_least_room = 96.0F;       // layout units: with less a panel is collapsed
constexpr float k_widest_bottom = 1120.0F;  // layout units
constexpr float k_bottom_row = 40.0F;       // layout units: a folded panel along the bottom
constexpr float k_high_window = 800.0F;
constexpr float k_least_bottom = 600.0F;  // with less between the side panels it reaches below them

/// Layout units that panels and dialogs have at least.
constexpr glm::vec2 k_least_size(960.0F, 600.0F);
constexpr float k_least_scale = 0.75F;  // with less nobody could read it

/// A panel in imgui.ini as ImGui writes it: the position in pixels of a window of k_layout_size.
glm::vec2 parse_pair(std::string_view text) {
  glm::vec2 pair(0.0F);
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.x);
  if (first.ec == std::errc() && first.ptr != end) std::from_chars(first.ptr + 1, end, pair.y);
  return pair;
}

}  // namespace

float fitting_scale(const glm::ivec2& size, float wanted) {
  const glm::vec2 most = glm::vec2(size) / k_least_size;
  const float fits = std::floor(16.0F * std::min(most.x, most.y)) / 16.0F;
  return std::min(wanted, std::max(fits, k_least_scale));
}

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

PanelLayout::PanelLayout(std::string_view ini) {
  for (PanelPlace& place : parse_layout(ini, k_panel_width)) panels_.push_back({.place = std::move(place)});
}

PanelLayout::Panel& PanelLayout::panel(std::string_view name) {
  const auto named = [&](const auto& candidate) { return candidate.name == name; };
  const auto found =
      std::find_if(panels_.begin(), panels_.end(), [&](const Panel& p) { return named(p.place); });
  if (found != panels_.end()) return *found;
  PanelPlace place{.name = std::string(name)};
  const std::vector<PanelPlace> shipped = parse_layout(shipped_layout(), k_panel_width);
  if (const auto known = std::find_if(shipped.begin(), shipped.end(), named); known != shipped.end())
    place = *known;
  return panels_.emplace_back(Panel{.place = place});
}

void PanelLayout::begin_frame(const glm::ivec2& size, float scale) {
  place_all_ = pending_ || size != size_ || scale != scale_;
  pending_ = false;
  size_ = size;
  scale_ = scale;
  for (Panel& each : panels_) {
    // What was not drawn there any more takes no room from those on the sides.
    if (each.bottom && !each.drawn) {
      each.bottom = false;
      each.box = {};
    }
    each.drawn = false;
  }
}

float PanelLayout::floor_at(const Ui& ui, float x, float y) const {
  float floor = static_cast<float>(size_.y), titles = 0.0F;
  for (const Panel& other : panels_) {
    if (other.box.min.x >= x + ui.px(k_panel_width) || x >= other.box.max.x) continue;
    if (other.bottom) floor = std::min(floor, other.box.min.y);
    if (!other.bottom && other.place.offset.y > y) titles += ui.px(k_title_height) + ui.px(8);
  }
  return floor - titles - ui.px(8);
}

glm::vec2 PanelLayout::corner_of(const Ui& ui, const Panel& each) const {
  const float width = ui.px(k_panel_width), gap = ui.px(8);
  glm::vec2 at = each.place.offset * scale_;
  if (each.place.from_right) at.x = static_cast<float>(size_.x) - width - at.x;
  if (sides_folded_) at.y = std::min(at.y, ui.px(k_bar_height + 8));
  // A panel dragged off a window that has shrunk would be lost.
  const glm::vec2 farthest(static_cast<float>(size_.x) - width,
                           floor_at(ui, at.x, each.place.offset.y) - ui.px(k_title_height));
  at = glm::clamp(at, glm::vec2(0.0F), glm::max(farthest, glm::vec2(0.0F)));
  for (const Panel& other : panels_) {
    const bool above = &other != &each && other.drawn && !other.bottom &&
                       other.place.offset.y < each.place.offset.y && other.box.min.x < at.x + width &&
                       at.x < other.box.max.x;
    if (above) at.y = std::max(at.y, other.box.max.y + gap);
  }
  return glm::round(at);
}

bool PanelLayout::begin(const Ui& ui, const char* name, const char* title) {
  CHECK(open_ == nullptr);
  Panel& each = panel(name);
  each.title = title != nullptr ? title : name;
  open_ = &each;
  const float width = ui.px(k_panel_width);
  const bool fresh = place_all_ || each.box.max == glm::vec2(0.0F);
  const bool moved = !fresh && each.box.min != each.put;
  if (moved) {
    each.place.from_right = 0.5F * (each.box.min.x + each.box.max.x) > 0.5F * static_cast<float>(size_.x);
    each.place.offset = each.box.min / scale_;
    if (each.place.from_right)
      each.place.offset.x = (static_cast<float>(size_.x) - each.box.min.x - width) / scale_;
    each.put = each.box.min;
  }
  const glm::vec2 at = moved ? each.put : corner_of(ui, each);
  const bool put_anew = fresh || at != each.put;
  if (put_anew) ImGui::SetNextWindowPos(each.put = at);
  const float room = floor_at(ui, each.put.x, each.place.offset.y) - each.put.y;
  // A title that a click has opened stays open.
  const bool crowded = room < ui.px(k_least_room) && (put_anew || each.squeezed);
  const bool squeezed = !each.toggle && (crowded || (sides_folded_ && (fresh || each.squeezed)));
  if (fresh || squeezed != each.squeezed) ImGui::SetNextWindowCollapsed(squeezed || each.place.collapsed);
  each.squeezed = squeezed;
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F), ImVec2(width, std::max(room, ui.px(64))));
  if (each.toggle) {
    ImGui::SetNextWindowCollapsed(!each.collapsed);
    each.toggle = false;
  }
  // ImGui's own title bar would have the body font and a heavy arrow.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(ui.px(8), 0.5F * (ui.px(k_title_height) - ui.fonts.body.size)));
  const bool open = ImGui::Begin(("##" + each.place.name).c_str(), nullptr,
                                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  each.box = window_box();
  each.drawn = true;
  each.collapsed = ImGui::IsWindowCollapsed();
  if (!each.squeezed) each.place.collapsed = each.collapsed;
  draw_title(ui, each);
  return open;
}

void PanelLayout::draw_title(const Ui& ui, Panel& each) const {
  ImDrawList& list = window_list();
  const float middle = each.box.min.y + 0.5F * ui.px(k_title_height);
  ui.memory->controls["panel " + each.title] = each.box;
  list.PushClipRect(each.box.min, each.box.max);
  draw_text(list, ui.strong(), {each.box.min.x + ui.px(12), middle - 0.5F * ui.fonts.strong.size},
            each.title);
  const glm::vec2 chevron(each.box.max.x - ui.px(18), middle), reach(ui.px(12));
  // A click anywhere on it; a drag moves the panel.
  const ScreenBox title{each.box.min, {each.box.max.x, each.box.min.y + ui.px(k_title_height)}};
  const bool hovered = ImGui::IsWindowHovered() && title.contains(mouse_at());
  draw_icon(list, each.collapsed ? Icon::chevron_right : Icon::chevron_down, chevron, ui.px(9),
            hovered ? ui.colours->text : ui.colours->muted);
  const bool focused = has_keyboard(ui, "title", {chevron - reach, chevron + reach});
  list.PopClipRect();
  const bool clicked = hovered && ImGui::IsMouseReleased(0) &&
                       title.contains(ImGui::GetIO().MouseClickedPos[0]) &&
                       glm::length(glm::vec2(ImGui::GetMouseDragDelta(0, 0.0F))) < ui.px(4);
  each.toggle = clicked || (focused && ui.memory->keyboard.takes(ControlKey::press));
}

void PanelLayout::end() {
  CHECK(open_ != nullptr);
  ImGui::End();
  open_ = nullptr;
}

bool PanelLayout::begin_bottom(const Ui& ui, const char* name, float folded_width, float wanted) {
  CHECK(open_ == nullptr);
  Panel& each = panel(name);
  each.drawn = false;
  const FreeArea area = free_area(false);
  const float gap = ui.px(12);
  float bottom = static_cast<float>(size_.y) - gap;
  for (const Panel& other : panels_)
    if (other.drawn && other.bottom) bottom = std::min(bottom, other.box.min.y - ui.px(8));
  open_ = &each;
  each.bottom = each.drawn = true;
  const float between = static_cast<float>(area.max.x - area.min.x) - 2.0F * gap;
  const bool high = static_cast<float>(size_.y) >= ui.px(k_high_window);
  const bool below = between < ui.px(std::max(k_least_bottom, high ? wanted : 0.0F));
  const bool narrow = each.place.collapsed && folded_width > 0.0F;
  const float room = narrow ? folded_width : below ? static_cast<float>(size_.x) - 2.0F * gap : between;
  const float middle = below && !narrow ? 0.5F * static_cast<float>(size_.x) : area.middle_x();
  const float width = std::min(room, ui.px(k_widest_bottom));
  place_window({std::round(middle), bottom}, {0.5F, 1.0F});
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F),
                                      ImVec2(width, std::max(bottom - ui.px(k_bar_height) - gap, ui.px(64))));
  ImGui::Begin(("##" + each.place.name).c_str(), nullptr, k_card_window);
  each.box = window_box();
  // Its size follows from what is in it, which is not known before the next frame: panels above it do not
  // give way to a guess.
  if (ImGui::IsWindowAppearing()) each.box.min.y = std::round(bottom - ui.px(k_bottom_row));
  ui.memory->controls["panel " + each.place.name] = each.box;
  return !each.place.collapsed;
}

void PanelLayout::fold_bottom(std::string_view name, bool collapsed) {
  for (Panel& each : panels_) {
    if (each.place.name == name) {
      each.place.collapsed = collapsed;
    } else if (each.bottom && !collapsed) {
      each.place.collapsed = true;
    }
  }
}

glm::vec2 FreeArea::beside(const glm::vec2& point, const glm::vec2& size, float gap) const {
  const glm::vec2 most = glm::vec2(max) - size;
  glm::vec2 corner = point + gap;
  if (corner.x > most.x) corner.x = point.x - gap - size.x;
  if (corner.y > most.y) corner.y = point.y - gap - size.y;
  return glm::max(glm::min(corner, most), glm::vec2(min));
}

FreeArea PanelLayout::free_area(bool panels_hidden) const {
  FreeArea area{.window = size_, .min = {0, 0}, .max = size_};
  if (panels_hidden) return area;
  area.min.y = static_cast<int>(k_bar_height * scale_);
  for (const Panel& each : panels_) {
    if (each.drawn && each.bottom) area.max.y = std::min(area.max.y, static_cast<int>(each.box.min.y));
    if (!each.drawn || each.collapsed || each.bottom) continue;
    if (each.place.from_right) {
      area.max.x = std::min(area.max.x, static_cast<int>(each.box.min.x));
    } else {
      area.min.x = std::max(area.min.x, static_cast<int>(each.box.max.x));
    }
  }
  // Panels that were moved into the middle leave no free area to speak of.
  if (area.max.x - area.min.x < size_.x / 3) {
    area.min.x = 0;
    area.max.x = size_.x;
  }
  return area;
}

std::string PanelLayout::text() const {
  std::vector<PanelPlace> places;
  for (const Panel& each : panels_) places.push_back(each.place);
  return layout_text(places, k_panel_width);
}

}  // namespace moldlight::gui
