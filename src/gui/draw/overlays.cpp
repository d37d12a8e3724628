#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "gui/draw/widgets.hpp"

namespace moldlight::gui {

bool begin_dialog(const Ui& ui, const char* name, const glm::vec2& size) {
  const glm::vec2 window = screen_size();
  place_window(glm::vec2(0.0F), glm::vec2(0.0F));
  ImGui::SetNextWindowSize(window);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.colours->scrim);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::Begin("Scrim", nullptr, k_fixed_window);
  ui.memory->scrim_clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0);
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();

  place_window(0.5F * window, glm::vec2(0.5F));
  const glm::vec2 most = window - glm::vec2(ui.px(16));
  if (size.y > 0.0F) {
    ImGui::SetNextWindowSize(glm::min(size, most));
  } else {
    ImGui::SetNextWindowSizeConstraints(ImVec2(size.x, 0.0F), most);
  }
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.colours->popup);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(16), ui.px(14)));
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
  if (size.y <= 0.0F) flags |= ImGuiWindowFlags_AlwaysAutoResize;
  ui.memory->keyboard.enter_layer();
  return ImGui::Begin(name, nullptr, flags);
}

bool end_dialog(const Ui& ui) {
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ui.memory->keyboard.leave_layer();
  return ui.memory->scrim_clicked;
}

bool begin_tooltip(const Ui& ui) {
  constexpr double k_rest_s = 0.5;
  if (!ImGui::IsItemHovered() || ImGui::IsAnyMouseDown()) return false;
  UiMemory& memory = *ui.memory;
  const glm::vec2 corner = item_box().min;
  const auto item = static_cast<ImGuiID>(static_cast<int>(corner.x) * 8192 + static_cast<int>(corner.y) + 1);
  if (item != memory.resting_on) {
    memory.resting_on = item;
    memory.resting_since_s = ui.now_s;
  }
  if (ui.now_s - memory.resting_since_s < k_rest_s) {
    memory.wake_s = std::min(memory.wake_s, memory.resting_since_s + k_rest_s);
    return false;
  }
  // Beside a panel, where it covers nothing of what it explains.
  constexpr float k_widest_panel = 300.0F, k_gap = 14.0F, k_lowest_bar = 60.0F,
                  k_low = 0.6F;  // layout units; of the screen's height
  const ScreenBox panel = window_box(), row = item_box();
  if (panel.max.x - panel.min.x <= ui.px(k_widest_panel)) {
    const bool left = panel.centre().x<0.5F * screen_size().x, low = row.max.y> k_low * screen_size().y;
    place_window(
        {left ? panel.max.x + ui.px(k_gap) : panel.min.x - ui.px(k_gap), low ? row.max.y : row.min.y},
        {left ? 0.0F : 1.0F, low ? 1.0F : 0.0F});
  } else if (panel.max.y < ui.px(k_lowest_bar)) {  // below the bar along the top
    const bool left = row.max.x < 0.7F * screen_size().x;
    place_window({left ? row.min.x : row.max.x, panel.max.y + ui.px(4)}, {left ? 0.0F : 1.0F, 0.0F});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(260));
  return true;
}

void end_tooltip() {
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void tooltip(const Ui& ui, std::string_view title, std::string_view text) {
  if (!begin_tooltip(ui)) return;
  if (!title.empty()) heading(ui, title);
  draw_item_text(title.empty() ? ui.colours->text : ui.colours->muted, text);
  end_tooltip();
}

void open_popup_below_item(const Ui& ui, const char* id) {
  const glm::vec2 gap(0.0F, ui.px(4));
  ui.memory->popups.open(ImGui::GetID(id), {item_box().min - gap, item_box().max + gap});
}

void open_popup_at_mouse(const Ui& ui, const char* id) {
  const glm::vec2 mouse = mouse_at();
  ui.memory->popups.open(ImGui::GetID(id), {mouse, mouse});
}

bool begin_popup(const Ui& ui, const char* id, float width) {
  Popups& popups = ui.memory->popups;
  const ImGuiID popup = ImGui::GetID(id);
  if (popups.depth_ >= popups.open_.size() || popups.open_[popups.depth_].id != popup) return false;
  Popups::Open& open = popups.open_[popups.depth_++];
  const glm::vec2 size = open.box.max - open.box.min, window = screen_size();
  glm::vec2 at(open.beside.min.x, open.beside.max.y);
  if (at.y + size.y > window.y && open.beside.min.y > size.y) at.y = open.beside.min.y - size.y;
  place_window(glm::max(glm::min(at, window - size), glm::vec2(0.0F)), glm::vec2(0.0F));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F), ImVec2(width > 0.0F ? width : window.x, window.y));
  // Not in the style of a window that it is opened from.
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.colours->popup);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(12), ui.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
  ImGui::Begin(fmt::format("Popup {:08x}", popup).c_str(), nullptr,
               k_fixed_window | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor();
  open.box = window_box();
  ui.memory->keyboard.enter_layer();
  ui.memory->keyboard.enter_layer();  // above the dialogs, too
  return true;
}

void end_popup(const Ui& ui) {
  ui.memory->keyboard.leave_layer();
  ui.memory->keyboard.leave_layer();
  ImGui::End();
  --ui.memory->popups.depth_;
}

}  // namespace moldlight::gui
