#include "gui/draw/keyboard.hpp"

#include <algorithm>
#include <utility>

#include <glm/vector_relational.hpp>

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
  const ImVec2 at = ImGui::GetIO().MousePos;
  const glm::vec2 mouse(at.x, at.y);
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

}  // namespace moldlight::gui
