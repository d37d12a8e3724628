#include "gui/draw/keyboard.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "gui/draw/widgets.hpp"

namespace moldlight::gui {

void Keyboard::begin_frame(ControlKey key, bool clicked) {
  order_ = std::exchange(drawn_, {});
  const bool gone = top_ == 0 && std::ranges::find(order_, focus_) == order_.end();
  if (clicked || gone) focus_ = 0;
  // What nobody took leads on.
  const ControlKey left_over = std::exchange(key_, key);
  top_ = layer_ = 0;
  arrived_ = false;
  if (key == ControlKey::next || key == ControlKey::former) {
    step(key == ControlKey::next ? 1 : -1);
    key_ = ControlKey::none;
  } else if (left_over == ControlKey::down || left_over == ControlKey::right) {
    step(1);
  } else if (left_over == ControlKey::up || left_over == ControlKey::left) {
    step(-1);
  }
}

void Keyboard::step(int by) {
  if (order_.empty()) return;
  const auto count = static_cast<int>(order_.size());
  const auto found = std::ranges::find(order_, focus_);
  const int at = found != order_.end() ? static_cast<int>(found - order_.begin()) + by
                 : by > 0              ? 0
                                       : count - 1;
  focus_ = order_[static_cast<std::size_t>((at + count) % count)];
  arrived_ = true;
}

bool Keyboard::visit(ImGuiID control) {
  if (layer_ < top_) return false;
  if (layer_ > top_) drawn_.clear();
  top_ = layer_;
  drawn_.push_back(control);
  return control == focus_;
}

bool Keyboard::takes(ControlKey key) {
  if (key_ != key) return false;
  key_ = ControlKey::none;
  return true;
}

int Keyboard::takes_steps(int page, int count) {
  if (takes(ControlKey::up)) return -1;
  if (takes(ControlKey::down)) return 1;
  if (takes(ControlKey::page_up)) return -page;
  if (takes(ControlKey::page_down)) return page;
  if (takes(ControlKey::home)) return -count;
  return takes(ControlKey::end) ? count : 0;
}

void Popups::begin_frame() {
  depth_ = 0;
  if (!ImGui::IsMouseClicked(0) && !ImGui::IsMouseClicked(1) && !ImGui::IsMouseClicked(2)) return;
  just_closed_ = 0;
  const glm::vec2 mouse = from_im(ImGui::GetIO().MousePos);
  while (!open_.empty()) {
    const ScreenBox& box = open_.back().box;
    if (glm::all(glm::greaterThanEqual(mouse, box.min)) && glm::all(glm::lessThan(mouse, box.max))) return;
    just_closed_ = open_.back().id;
    open_.pop_back();
  }
}

void Popups::open(ImGuiID popup, const ScreenBox& beside) {
  if (std::exchange(just_closed_, 0) == popup) return;
  open_.resize(std::min(open_.size(), depth_));
  open_.push_back({.id = popup, .beside = beside, .box = {}});
}

bool Popups::close_one() {
  if (open_.empty()) return false;
  open_.pop_back();
  return true;
}

void open_popup_below_item(const Ui& ui, const char* id) {
  const glm::vec2 gap(0.0F, ui.px(4));
  ui.memory->popups.open(ImGui::GetID(id),
                         {from_im(ImGui::GetItemRectMin()) - gap, from_im(ImGui::GetItemRectMax()) + gap});
}

void open_popup_at_mouse(const Ui& ui, const char* id) {
  const glm::vec2 mouse = from_im(ImGui::GetIO().MousePos);
  ui.memory->popups.open(ImGui::GetID(id), {mouse, mouse});
}

bool begin_popup(const Ui& ui, const char* id, float width) {
  Popups& popups = ui.memory->popups;
  const ImGuiID popup = ImGui::GetID(id);
  if (popups.depth_ >= popups.open_.size() || popups.open_[popups.depth_].id != popup) return false;
  Popups::Open& open = popups.open_[popups.depth_++];
  const glm::vec2 size = open.box.max - open.box.min, window = from_im(ImGui::GetIO().DisplaySize);
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
  const glm::vec2 corner = from_im(ImGui::GetWindowPos());
  open.box = {corner, corner + from_im(ImGui::GetWindowSize())};
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
