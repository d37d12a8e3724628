// GLFW's window with its OpenGL context, and what it tells of keys and dropped files.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "gl/context.hpp"
#include "gui/input/keys.hpp"

struct GLFWwindow;

namespace moldlight::gui {

/// Starts and ends GLFW. Throws Error with its reason, where there is no display.
class GlfwLibrary {
 public:
  GlfwLibrary();
  ~GlfwLibrary();
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

class WindowContext final : public gl::Context {
 public:
  /// Throws Error where the display has no OpenGL 3.3.
  WindowContext(const glm::ivec2& size, const std::string& title);
  ~WindowContext() override;

  [[nodiscard]] GLFWwindow* window() const { return window_; }
  [[nodiscard]] glm::ivec2 framebuffer_size() const;
  [[nodiscard]] float content_scale() const;
  void show();
  void present();
  void set_title(const std::string& title);

  /// What came since the last call.
  struct Events {
    std::vector<KeyPress> keys;
    std::vector<std::string> dropped;
  };
  [[nodiscard]] Events take_events();

 private:
  void bind() override;
  void unbind() noexcept override;

  GLFWwindow* window_ = nullptr;
  Events events_;
};

}  // namespace moldlight::gui
