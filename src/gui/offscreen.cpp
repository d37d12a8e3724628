#include "gui/offscreen.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "classify/headless.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_frame_s = 1.0 / 60.0;
constexpr int k_most_settling_frames = 600;
constexpr std::chrono::minutes k_patience(10);

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

/// ImGui's renderer finds its functions through GLX's or EGL's table, which OSMesa has no part in.
std::unique_ptr<gl::Context> egl_context() { return moldlight::create_context(Backend::egl); }

}  // namespace

OffscreenWindow::OffscreenWindow(const OffscreenOptions& options)
    : context_(egl_context()), content_scale_(options.content_scale) {
  target_ = std::make_unique<gl::ColourTarget>(context_->functions(), options.size);
  AppOptions app;
  app.reading = options.reading;
  app.user = options.user;
  app.shipped_parts = options.shipped_parts;
  app.wake = options.wake;
  app.make_context = create_context;
  app_ = std::make_unique<App>(*context_, std::move(app));
}

OffscreenWindow::~OffscreenWindow() { context_->make_current(); }

void OffscreenWindow::press_key(const KeyPress& press) {
  keys_.push_back(press);
  hold_modifiers(press.ctrl, press.shift, press.alt);
}

void OffscreenWindow::hold_modifiers(bool ctrl, bool shift, bool alt) {
  ctrl_ = ctrl;
  shift_ = shift;
  alt_ = alt;
}

void OffscreenWindow::resize(const glm::ivec2& size) {
  context_->make_current();
  target_ = std::make_unique<gl::ColourTarget>(context_->functions(), size);
}

void OffscreenWindow::feed_imgui() const {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = im(glm::vec2(target_->size()));
  io.DisplayFramebufferScale = ImVec2(1.0F, 1.0F);
  io.DeltaTime = static_cast<float>(k_frame_s);
  const auto pressed = [&](int key) {
    return std::any_of(keys_.begin(), keys_.end(), [&](const KeyPress& press) { return press.key == key; });
  };
#if IMGUI_VERSION_NUM >= 18700
  // What comes in one frame is to act in that frame.
  io.ConfigInputTrickleEventQueue = false;
  io.AddMousePosEvent(mouse_.x, mouse_.y);
  for (int button = 0; button < 3; ++button)
    io.AddMouseButtonEvent(button, buttons_[static_cast<std::size_t>(button)]);
  if (wheel_ != 0.0F) io.AddMouseWheelEvent(0.0F, wheel_);
  io.AddKeyEvent(ImGuiMod_Ctrl, ctrl_);
  io.AddKeyEvent(ImGuiMod_Shift, shift_);
  io.AddKeyEvent(ImGuiMod_Alt, alt_);
  for (const auto& [key, name] : k_keys) io.AddKeyEvent(name, pressed(key));
#else
  io.MousePos = ImVec2(mouse_.x, mouse_.y);
  for (std::size_t button = 0; button < 3; ++button) io.MouseDown[button] = buttons_[button];
  io.MouseWheel = wheel_;
  io.KeyCtrl = ctrl_;
  io.KeyShift = shift_;
  io.KeyAlt = alt_;
  for (const auto& [key, name] : k_keys) {
    io.KeyMap[name] = key;
    io.KeysDown[key] = pressed(key);
  }
#endif
  if (!typed_.empty()) io.AddInputCharactersUTF8(typed_.c_str());
}

ScreenBox OffscreenWindow::control(std::string_view name) const {
  const auto found = app_->controls().find(name);
  if (found == app_->controls().end())
    throw UsageError(fmt::format("there is no control '{}' to be seen", name));
  return found->second;
}

bool OffscreenWindow::frame() {
  context_->make_current();
  now_s_ += k_frame_s;
  FrameInput input{.size = target_->size(),
                   .content_scale = content_scale_,
                   .now_s = now_s_,
                   .keys = keys_,
                   .dropped = std::exchange(dropped_, {})};
  app_->prepare(input);
  feed_imgui();
  app_->frame(input);
  const bool refining = app_->draw({.framebuffer = target_->framebuffer(), .size = target_->size()});
  keys_.clear();
  typed_.clear();
  wheel_ = 0.0F;
  return refining;
}

void OffscreenWindow::frames(int count) {
  for (int k = 0; k < count; ++k) frame();
}

void OffscreenWindow::settle() {
  // Input of this moment still has to reach the panels, and what it changes has to be laid out.
  frames(4);
  for (int k = 0; k < k_most_settling_frames && (app_->next_frame_s() <= now_s_); ++k) frame();
}

void OffscreenWindow::wait_while(const std::function<bool()>& waiting, const char* complaint) {
  const auto start = std::chrono::steady_clock::now();
  while (waiting()) {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (std::chrono::steady_clock::now() - start > k_patience) throw Error(complaint);
  }
  settle();
}

void OffscreenWindow::wait_until_prepared() {
  frame();
  wait_while([&] { return app_->preparing(); }, "the pictures take too long");
}

void OffscreenWindow::wait_until_loaded() {
  frame();
  wait_while([&] { return app_->state().loading.has_value(); }, "the part takes too long to load");
}

void OffscreenWindow::wait_until_swept() {
  frame();
  wait_while([&] { return app_->state().sweep.running.has_value(); }, "the sweep takes too long");
}

void OffscreenWindow::wait_until_measured() {
  wait_while([&] { return app_->measuring(); }, "the measuring takes too long");
}

}  // namespace moldlight::gui
