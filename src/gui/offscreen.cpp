#include "gui/offscreen.hpp"

#include <chrono>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "gui/input/imgui_feed.hpp"
#include "session/headless.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_frame_s = 1.0 / 60.0;
constexpr int k_most_settling_frames = 600;
constexpr std::chrono::minutes k_patience(10);

/// ImGui's renderer finds its functions through GLX's or EGL's table, which OSMesa has no part in.
std::unique_ptr<gl::Context> egl_context() { return gl::create_headless_context(gl::HeadlessBackend::egl); }

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
  feed({.size = target_->size(),
        .delta_s = k_frame_s,
        .mouse = mouse_,
        .buttons = buttons_,
        .wheel = wheel_,
        .ctrl = ctrl_,
        .shift = shift_,
        .alt = alt_,
        .keys = keys_,
        .text = typed_});
}

ControlPlace OffscreenWindow::control(std::string_view name) const {
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

void OffscreenWindow::wait_until_prepared() {
  frame();
  while (app_->preparing()) {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  settle();
}

void OffscreenWindow::wait_until_loaded() {
  const auto start = std::chrono::steady_clock::now();
  do {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (std::chrono::steady_clock::now() - start > k_patience) throw Error("the part takes too long to load");
  } while (app_->state().loading);
  settle();
}

void OffscreenWindow::wait_until_swept() {
  const auto start = std::chrono::steady_clock::now();
  do {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (std::chrono::steady_clock::now() - start > k_patience) throw Error("the sweep takes too long");
  } while (app_->state().sweep.running);
  settle();
}

void OffscreenWindow::wait_until_measured() {
  const auto start = std::chrono::steady_clock::now();
  while (app_->measuring()) {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (std::chrono::steady_clock::now() - start > k_patience) throw Error("the measuring takes too long");
  }
  settle();
}

}  // namespace moldlight::gui
