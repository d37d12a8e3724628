#include "gui/window_context.hpp"

#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>

#include "base/error.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gui {

namespace {

std::string glfw_reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  std::string reason = text != nullptr ? text : "no reason given";
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return reason;
}

WindowContext::Events& events_of(GLFWwindow* window) {
  return *static_cast<WindowContext::Events*>(glfwGetWindowUserPointer(window));
}

}  // namespace

GlfwLibrary::GlfwLibrary() {
  if (glfwInit() == GLFW_FALSE) throw Error(glfw_reason());
}

GlfwLibrary::~GlfwLibrary() { glfwTerminate(); }

WindowContext::WindowContext(const glm::ivec2& size, const std::string& title) {
  gl::prepare_mesa_environment();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "moldlight");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "moldlight");
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) throw Error(glfw_reason());
  glfwSetWindowSizeLimits(window_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowUserPointer(window_, &events_);
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
    if (action == GLFW_RELEASE || key == GLFW_KEY_UNKNOWN) return;
    events_of(window).keys.push_back({.key = key,
                                      .ctrl = (modifiers & GLFW_MOD_CONTROL) != 0,
                                      .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                      .alt = (modifiers & GLFW_MOD_ALT) != 0});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    events_of(window).dropped.insert(events_of(window).dropped.end(), paths, paths + count);
  });
  try {
    initialise("window", [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
  } catch (...) {
    glfwDestroyWindow(window_);
    throw;
  }
  glfwSwapInterval(1);
}

WindowContext::~WindowContext() {
  release_current();
  glfwDestroyWindow(window_);
}

glm::ivec2 WindowContext::framebuffer_size() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

float WindowContext::content_scale() const {
  float x = 1.0F, y = 1.0F;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0.0F ? x : 1.0F;
}

void WindowContext::show() { glfwShowWindow(window_); }

void WindowContext::present() { glfwSwapBuffers(window_); }

void WindowContext::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

WindowContext::Events WindowContext::take_events() { return std::exchange(events_, {}); }

void WindowContext::bind() { glfwMakeContextCurrent(window_); }

void WindowContext::unbind() noexcept { glfwMakeContextCurrent(nullptr); }

}  // namespace moldlight::gui
