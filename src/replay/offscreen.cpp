#include "replay/offscreen.hpp"

#include <chrono>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "classify/headless.hpp"

namespace moldlight::gui {

constexpr int k_most_settling_frames = 600;
constexpr int k_drawn_waiting = 8;  // one frame in so many: what is waited for needs the cores
constexpr std::chrono::minutes k_patience(10);

// ImGui's renderer finds its functions through GLX's or EGL's table, which OSMesa has no part in.
OffscreenWindow::OffscreenWindow(const OffscreenOptions& options)
    : context_(moldlight::create_context(Backend::egl)),
      size_(options.size),
      content_scale_(options.content_scale) {
  AppOptions app = options;
  app.make_context = create_context;
  app_ = std::make_unique<App>(*context_, std::move(app));
}

OffscreenWindow::~OffscreenWindow() { context_->make_current(); }

void OffscreenWindow::press_key(const KeyPress& press) {
  hold_modifiers(press.ctrl, press.shift, press.alt);
  input_.press_key(now_s_, press);
  input_.release_key(now_s_, press.key);
}

ScreenBox OffscreenWindow::control(std::string_view name) const {
  const auto found = app_->controls().find(name);
  if (found == app_->controls().end())
    throw UsageError(fmt::format("there is no visible control '{}'", name));
  return found->second;
}

void OffscreenWindow::make_frame() {
  context_->make_current();
  FrameInput input{.size = size_,
                   .content_scale = content_scale_,
                   .now_s = now_s_,
                   .played = {},
                   .dropped = std::exchange(dropped_, {})};
  app_->prepare(input);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = glm::vec2(size_);
  io.DisplayFramebufferScale = ImVec2(1.0F, 1.0F);
  input.played = input_.play(io, now_s_);
  app_->frame(input);
}

bool OffscreenWindow::frame_at_once() {
  make_frame();
  if (!target_ || target_->size() != size_)
    target_ = std::make_unique<gl::ColourTarget>(context_->functions(), size_);
  return app_->draw({.framebuffer = target_->framebuffer(), .size = size_});
}

void OffscreenWindow::lay_out() {
  pass_time(k_frame_s);
  make_frame();
  ImGui::EndFrame();
}

void OffscreenWindow::settle() {
  // Input of this moment still has to reach the panels, and what it changes has to be laid out.
  frames(4);
  frames_asked_for();
}

void OffscreenWindow::frames_asked_for() {
  for (int k = 0; k < k_most_settling_frames && (!input_.empty() || app_->next_frame_s() <= now_s_); ++k)
    frame();
}

void OffscreenWindow::wait_while(const std::function<bool()>& waiting, const char* complaint) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; waiting(); ++k) {
    if (k % k_drawn_waiting == 0) {
      frame();
    } else {
      lay_out();
    }
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
  wait_while([&] { return app_->sweeping(); }, "the sweep takes too long");
}

void OffscreenWindow::wait_until_measured() {
  wait_while([&] { return app_->measuring(); }, "the measuring takes too long");
}

}  // namespace moldlight::gui
