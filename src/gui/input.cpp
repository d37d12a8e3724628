#include "gui/input.hpp"

#include <algorithm>
#include <cfloat>
#include <initializer_list>
#include <utility>

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace moldlight::gui {

namespace {

constexpr double k_least_frame_s = 1e-5;  // ImGui's clock has to run
constexpr glm::vec2 k_nowhere(-1.0e6F);

/// The keys that ImGui listens to. Tab is not among them: ImGui knows no controls but its own.
constexpr std::pair<int, ImGuiKey> k_keys[] = {
    {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
    {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    {GLFW_KEY_UP, ImGuiKey_UpArrow},
    {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
    {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
    {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
    {GLFW_KEY_HOME, ImGuiKey_Home},
    {GLFW_KEY_END, ImGuiKey_End},
    {GLFW_KEY_INSERT, ImGuiKey_Insert},
    {GLFW_KEY_DELETE, ImGuiKey_Delete},
    {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
    {GLFW_KEY_SPACE, ImGuiKey_Space},
    {GLFW_KEY_ENTER, ImGuiKey_Enter},
    {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
#if IMGUI_VERSION_NUM >= 18700
    {GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
#else
    {GLFW_KEY_KP_ENTER, ImGuiKey_KeyPadEnter},
#endif
    {GLFW_KEY_A, ImGuiKey_A},
    {GLFW_KEY_C, ImGuiKey_C},
    {GLFW_KEY_V, ImGuiKey_V},
    {GLFW_KEY_X, ImGuiKey_X},
    {GLFW_KEY_Y, ImGuiKey_Y},
    {GLFW_KEY_Z, ImGuiKey_Z},
};

constexpr std::pair<int, ControlKey> k_control_keys[] = {
    {GLFW_KEY_SPACE, ControlKey::press},    {GLFW_KEY_ENTER, ControlKey::press},
    {GLFW_KEY_KP_ENTER, ControlKey::press}, {GLFW_KEY_LEFT, ControlKey::left},
    {GLFW_KEY_RIGHT, ControlKey::right},    {GLFW_KEY_UP, ControlKey::up},
    {GLFW_KEY_DOWN, ControlKey::down},      {GLFW_KEY_PAGE_UP, ControlKey::page_up},
    {GLFW_KEY_HOME, ControlKey::home},      {GLFW_KEY_PAGE_DOWN, ControlKey::page_down},
    {GLFW_KEY_END, ControlKey::end},        {GLFW_KEY_BACKSPACE, ControlKey::erase},
};

void set_key(ImGuiIO& io, int key, bool down) {
  const auto* known = std::find_if(std::begin(k_keys), std::end(k_keys),
                                   [&](const auto& entry) { return entry.first == key; });
  if (known == std::end(k_keys)) return;
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(known->second, down);
#else
  io.KeyMap[known->second] = key;
  io.KeysDown[key] = down;
#endif
}

void set_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
#else
  io.KeyCtrl = ctrl;
  io.KeyShift = shift;
  io.KeyAlt = alt;
#endif
}

}  // namespace

ControlKey control_key(const KeyPress& press) {
  if (press.ctrl || press.alt) return ControlKey::none;
  if (press.key == GLFW_KEY_TAB) return press.shift ? ControlKey::former : ControlKey::next;
  const auto known = std::ranges::find(k_control_keys, press.key, &std::pair<int, ControlKey>::first);
  return known == std::end(k_control_keys) ? ControlKey::none : known->second;
}

void InputQueue::move_mouse(double time_s, const glm::vec2& to) {
  events_.push_back({.kind = Kind::move, .time_s = time_s, .at = to});
}

void InputQueue::mouse_left(double time_s) { move_mouse(time_s, k_nowhere); }

void InputQueue::set_button(double time_s, int button, bool down) {
  events_.push_back({.kind = Kind::button, .time_s = time_s, .code = button, .down = down});
}

void InputQueue::turn_wheel(double time_s, float notches) {
  events_.push_back({.kind = Kind::wheel, .time_s = time_s, .at = {0.0F, notches}});
}

void InputQueue::press_key(double time_s, const KeyPress& press) {
  events_.push_back({.kind = Kind::press, .time_s = time_s, .code = press.key, .press = press});
}

void InputQueue::release_key(double time_s, int key) {
  events_.push_back({.kind = Kind::release, .time_s = time_s, .code = key});
}

void InputQueue::hold_modifiers(double time_s, bool ctrl, bool shift, bool alt) {
  events_.push_back({.kind = Kind::modifiers,
                     .time_s = time_s,
                     .press = {.key = 0, .ctrl = ctrl, .shift = shift, .alt = alt}});
}

void InputQueue::type(double time_s, std::string_view utf8) {
  events_.push_back({.kind = Kind::text, .time_s = time_s, .text = std::string(utf8)});
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
#if IMGUI_VERSION_NUM >= 18700
      io.AddMouseWheelEvent(0.0F, event.at.y);
#else
      io.MouseWheel += event.at.y;
#endif
      break;
    case Kind::press:
      set_key(io, event.code, true);
      played.keys.push_back(event.press);
      break;
    case Kind::release:
      set_key(io, event.code, false);
      break;
    case Kind::modifiers:
      set_modifiers(io, event.press.ctrl, event.press.shift, event.press.alt);
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
#if IMGUI_VERSION_NUM >= 18700
  io.ConfigInputTrickleEventQueue = false;  // that has been done here
  io.AddMousePosEvent(mouse_.x, mouse_.y);
  for (int button = 0; button < 3; ++button)
    io.AddMouseButtonEvent(button, buttons_[static_cast<std::size_t>(button)]);
#else
  io.MousePos = mouse_ == k_nowhere ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(mouse_.x, mouse_.y);
  for (std::size_t button = 0; button < buttons_.size(); ++button) io.MouseDown[button] = buttons_[button];
#endif
  io.DeltaTime = static_cast<float>(std::max(time_s - clock_s_, k_least_frame_s));
  clock_s_ = std::max(clock_s_, time_s);
  return played;
}

}  // namespace moldlight::gui
