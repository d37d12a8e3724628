#include "gui/input/imgui_feed.hpp"

#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace moldlight::gui {

namespace {

/// The keys that ImGui's text fields listen to.
constexpr std::pair<int, ImGuiKey> k_keys[] = {
    {GLFW_KEY_TAB, ImGuiKey_Tab},
    {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
    {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    {GLFW_KEY_UP, ImGuiKey_UpArrow},
    {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
    {GLFW_KEY_HOME, ImGuiKey_Home},
    {GLFW_KEY_END, ImGuiKey_End},
    {GLFW_KEY_DELETE, ImGuiKey_Delete},
    {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
    {GLFW_KEY_ENTER, ImGuiKey_Enter},
    {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    {GLFW_KEY_A, ImGuiKey_A},
    {GLFW_KEY_C, ImGuiKey_C},
    {GLFW_KEY_V, ImGuiKey_V},
};

}  // namespace

void feed(const ImguiInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(input.size.x), static_cast<float>(input.size.y));
  io.DisplayFramebufferScale = ImVec2(1.0F, 1.0F);
  io.DeltaTime = static_cast<float>(input.delta_s);
  const auto pressed = [&](int key) {
    return std::any_of(input.keys.begin(), input.keys.end(),
                       [&](const KeyPress& press) { return press.key == key; });
  };
#if IMGUI_VERSION_NUM >= 18700
  // What comes in one frame is to act in that frame.
  io.ConfigInputTrickleEventQueue = false;
  io.AddMousePosEvent(input.mouse.x, input.mouse.y);
  for (int button = 0; button < 3; ++button)
    io.AddMouseButtonEvent(button, input.buttons[static_cast<std::size_t>(button)]);
  if (input.wheel != 0.0F) io.AddMouseWheelEvent(0.0F, input.wheel);
  io.AddKeyEvent(ImGuiMod_Ctrl, input.ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, input.shift);
  io.AddKeyEvent(ImGuiMod_Alt, input.alt);
  for (const auto& [key, name] : k_keys) io.AddKeyEvent(name, pressed(key));
#else
  io.MousePos = ImVec2(input.mouse.x, input.mouse.y);
  for (std::size_t button = 0; button < 3; ++button) io.MouseDown[button] = input.buttons[button];
  io.MouseWheel = input.wheel;
  io.KeyCtrl = input.ctrl;
  io.KeyShift = input.shift;
  io.KeyAlt = input.alt;
  for (const auto& [key, name] : k_keys) {
    io.KeyMap[name] = key;
    io.KeysDown[key] = pressed(key);
  }
#endif
  if (!input.text.empty()) io.AddInputCharactersUTF8(input.text.c_str());
}

}  // namespace moldlight::gui
