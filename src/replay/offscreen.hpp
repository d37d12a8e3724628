// The whole window without a display: the app on a context without a window, fed with recorded input.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gui/app.hpp"

namespace moldlight::gui {

/// The window has its own `make_context`.
struct OffscreenOptions : AppOptions {
  glm::ivec2 size{1280, 720};
  float content_scale = 1.0F;
};

/// One of these a process at a time. Time is counted in frames, so that the same input gives the same
/// picture.
class OffscreenWindow {
 public:
  /// Throws Error where there is no EGL context.
  explicit OffscreenWindow(const OffscreenOptions& options);
  ~OffscreenWindow();

  [[nodiscard]] App& app() { return *app_; }
  [[nodiscard]] const App& app() const { return *app_; }
  [[nodiscard]] const AppState& state() const { return app_->state(); }
  [[nodiscard]] const gl::Context& context() const { return *context_; }

  /// Input from the next frame on.
  void move_mouse(const glm::vec2& to) { input_.move_mouse(now_s_, to); }
  void set_button(int button, bool down) { input_.set_button(now_s_, button, down); }
  void turn_wheel(float notches) { input_.turn_wheel(now_s_, notches); }
  /// And lets go of it.
  void press_key(const KeyPress& press);
  void hold_modifiers(bool ctrl, bool shift, bool alt) { input_.hold_modifiers(now_s_, ctrl, shift, alt); }
  void type(const std::string& text) { input_.type(now_s_, text); }
  void drop(const std::string& path) { dropped_.push_back(path); }
  void resize(const glm::ivec2& size) { size_ = size; }
  void set_content_scale(float scale) { content_scale_ = scale; }

  /// One frame of 1/60 s; returns true while the picture is being refined.
  bool frame() {
    pass_time(k_frame_s);
    return frame_at_once();
  }
  /// The same without time of its own.
  bool frame_at_once();
  /// A frame whose panels are laid out, but not drawn.
  void lay_out();
  /// Lets time go by without a frame, as a slow one does.
  void pass_time(double seconds) { now_s_ += seconds; }
  /// Frames only as the app asks for them now, as on the desktop.
  void frames_asked_for();
  void frames(int count) {
    for (int k = 0; k < count; ++k) frame();
  }
  /// Frames until nothing moves and the picture is final. What is measured is not waited for.
  void settle();
  /// Waits until the part is loaded or failed, or the figures are measured. Throws Error after a time limit.
  void wait_until_loaded();
  void wait_until_measured();
  /// Waits for the pictures of the start page.
  void wait_until_prepared();
  /// Waits until no sweep runs and its directions have their pictures.
  void wait_until_swept();

  /// The middle of a control (see App::controls). Throws UsageError where there is none of that name.
  [[nodiscard]] ScreenBox control(std::string_view name) const;

  /// RGBA8, rows from above, of the last frame; one must have been drawn in this size.
  [[nodiscard]] std::vector<std::uint8_t> pixels() const { return target_->read(); }
  [[nodiscard]] glm::ivec2 size() const { return size_; }

 private:
  static constexpr double k_frame_s = 1.0 / 60.0;

  /// All of a frame but its drawing.
  void make_frame();
  /// Throws Error with the complaint after a time limit.
  void wait_while(const std::function<bool()>& waiting, const char* complaint);

  std::unique_ptr<gl::Context> context_;
  glm::ivec2 size_;
  std::unique_ptr<gl::ColourTarget> target_;  // of the last frame that was drawn
  std::unique_ptr<App> app_;
  float content_scale_;
  InputQueue input_;
  std::vector<std::string> dropped_;
  double now_s_ = 0.0;
};

}  // namespace moldlight::gui
