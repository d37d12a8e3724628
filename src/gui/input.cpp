#include "gui/input.hpp"

#include <algorithm>
#include <cfloat>
#include <initializer_list>
#include <optional>

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace moldlight::gui {

namespace {

constexpr double k_least_frame_s = 1e-5;  // ImGui's clock has to run

/// The keys that ImGui listens to, and what they ask of controls. Tab is not among them: ImGui knows no
/// controls but its own.
struct KnownKey {
  int key;
  ImGuiKey imgui;
  ControlKey control = ControlKey::none;
};
constexpr KnownKey k_keys[] = {
    {GLFW_KEY_LEFT, ImGuiKey_LeftArrow, ControlKey::left},
    {GLFW_KEY_RIGHT, ImGuiKey_RightArrow, ControlKey::right},
    {GLFW_KEY_UP, ImGuiKey_UpArrow, ControlKey::up},
    {GLFW_KEY_DOWN, ImGuiKey_DownArrow, ControlKey::down},
    {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp, ControlKey::page_up},
    {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown, ControlKey::page_down},
    {GLFW_KEY_HOME, ImGuiKey_Home, ControlKey::home},
    {GLFW_KEY_END, ImGuiKey_End, ControlKey::end},
    {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace, ControlKey::erase},
    {GLFW_KEY_SPACE, ImGuiKey_Space, ControlKey::press},
    {GLFW_KEY_ENTER, ImGuiKey_Enter, ControlKey::press},
    {GLFW_KEY_KP_ENTER, ImGuiKey_KeyPadEnter, ControlKey::press},
    {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    {GLFW_KEY_INSERT, ImGuiKey_Insert},
    {GLFW_KEY_DELETE, ImGuiKey_Delete},
    {GLFW_KEY_A, ImGuiKey_A},
    {GLFW_KEY_C, ImGuiKey_C},
    {GLFW_KEY_V, ImGuiKey_V},
    {GLFW_KEY_X, ImGuiKey_X},
    {GLFW_KEY_Y, ImGuiKey_Y},
    {GLFW_KEY_Z, ImGuiKey_Z},
};

const KnownKey* known_key(int key) {
  const auto* known = std::ranges::find(k_keys, key, &KnownKey::key);
  return known == std::end(k_keys) ? nullptr : known;
}

void set_key(ImGuiIO& io, int key, bool down) {
  const KnownKey* known = known_key(key);
  if (known == nullptr) return;
  io.KeyMap[known->imgui] = key;
  io.KeysDown[key] = down;
}

}  // namespace

ControlKey control_key(const KeyPress& press) {
  if (press.ctrl || press.alt) return ControlKey::none;
  if (press.key == GLFW_KEY_TAB) return press.shift ? ControlKey::former : ControlKey::next;
  const KnownKey* known = known_key(press.key);
  return known == nullptr ? ControlKey::none : known->control;
}

bool InputQueue::joins(const Event& event, const Event& former, bool typing) {
  const auto follows = [&](std::initializer_list<Kind> kinds) {
    return std::find(kinds.begin(), kinds.end(), former.kind) != kinds.end();
  };
  switch (event.kind) {
    case Kind::move:
    case Kind::wheel:
      return follows({event.kind});
    case Kind::button:
      return follows({Kind::modifiers});
    case Kind::press: {
      const bool writes = event.code >= GLFW_KEY_SPACE && event.code < GLFW_KEY_ESCAPE && !event.press.ctrl;
      return follows({Kind::modifiers}) || (typing && writes && follows({Kind::text, Kind::release}));
    }
    case Kind::text:  // in the frame of its key, so that a field which that opens does not get it
      return follows({Kind::text, Kind::press});
    case Kind::release:
      return follows({Kind::release, Kind::modifiers, Kind::text});
    case Kind::modifiers:  // before what they modify
      return follows({Kind::release, Kind::modifiers, Kind::move});
  }
  return false;
}

void InputQueue::act(const Event& event, ImGuiIO& io, Played& played) {
  switch (event.kind) {
    case Kind::move:
      mouse_ = event.at;
      break;
    case Kind::button:
      buttons_[static_cast<std::size_t>(event.code)] = event.down;
      break;
    case Kind::wheel:
      io.MouseWheel += event.at.y;
      break;
    case Kind::press:
      set_key(io, event.code, true);
      played.keys.push_back(event.press);
      break;
    case Kind::release:
      set_key(io, event.code, false);
      break;
    case Kind::modifiers:
      io.KeyCtrl = event.press.ctrl;
      io.KeyShift = event.press.shift;
      io.KeyAlt = event.press.alt;
      break;
    case Kind::text:
      io.AddInputCharactersUTF8(event.text.c_str());
      break;
  }
}

InputQueue::Played InputQueue::play(ImGuiIO& io, double now_s) {
  Played played;
  double time_s = now_s;
  std::optional<Event> former;
  while (!events_.empty() && (!former || joins(events_.front(), *former, io.WantTextInput))) {
    former = std::move(events_.front());
    events_.pop_front();
    act(*former, io, played);
    played.any = true;
  }
  if (former && (former->kind == Kind::button || !events_.empty())) time_s = former->time_s;
  io.MousePos = mouse_ == k_nowhere ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(mouse_.x, mouse_.y);
  for (std::size_t button = 0; button < buttons_.size(); ++button) io.MouseDown[button] = buttons_[button];
  io.DeltaTime = static_cast<float>(std::max(time_s - clock_s_, k_least_frame_s));
  clock_s_ = std::max(clock_s_, time_s);
  return played;
}

}  // namespace moldlight::gui
