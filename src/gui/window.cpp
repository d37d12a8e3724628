#include "gui/window.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "classify/headless.hpp"
#include "classify/option_table.hpp"
#include "gl/colour_target.hpp"
#include "gl/headless_backends.hpp"
#include "gui/app.hpp"
#include "gui/store/files.hpp"

namespace moldlight::gui {

namespace {

constexpr glm::ivec2 k_first_size(1280, 800);
constexpr const char* k_headless_advice =
    "without a display use moldlight classify or moldlight view PART --screenshot OUT.png";

std::string glfw_reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  std::string reason = text != nullptr ? text : "no reason given";
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return reason;
}

/// Starts and ends GLFW.
class GlfwLibrary {
 public:
  GlfwLibrary() {
    if (glfwInit() == GLFW_FALSE)
      throw Error(fmt::format("no display to open a window on ({}); {}", glfw_reason(), k_headless_advice));
  }
  ~GlfwLibrary() { glfwTerminate(); }
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

/// GLFW's window with its OpenGL context, and what it tells of keys and dropped files.
class WindowContext final : public gl::Context {
 public:
  /// Throws Error where the display has no OpenGL 3.3.
  WindowContext() {
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
    const gl::Turn turn(true);
    window_ = glfwCreateWindow(k_first_size.x, k_first_size.y, "moldlight", nullptr, nullptr);
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
      initialise("window",
                 [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
    } catch (...) {
      glfwDestroyWindow(window_);
      throw;
    }
    glfwSwapInterval(1);
  }
  ~WindowContext() override {
    release_current();
    const gl::Turn turn(draws_on_cpu());
    glfwDestroyWindow(window_);
  }

  [[nodiscard]] GLFWwindow* window() const { return window_; }
  [[nodiscard]] glm::ivec2 framebuffer_size() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
  }
  [[nodiscard]] float content_scale() const {
    float x = 1.0F, y = 1.0F;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0.0F ? x : 1.0F;
  }

  struct Events {
    std::vector<KeyPress> keys;
    std::vector<std::string> dropped;
  };
  /// What came since the last call.
  [[nodiscard]] Events take_events() { return std::exchange(events_, {}); }

 private:
  static Events& events_of(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
  }
  void bind() override { glfwMakeContextCurrent(window_); }
  void unbind() noexcept override { glfwMakeContextCurrent(nullptr); }

  GLFWwindow* window_ = nullptr;
  Events events_;
};

/// GLFW's side of ImGui: mouse, keys, text, clipboard, cursors.
class GlfwInput {
 public:
  explicit GlfwInput(GLFWwindow* window) { ImGui_ImplGlfw_InitForOpenGL(window, true); }
  ~GlfwInput() { ImGui_ImplGlfw_Shutdown(); }
  GlfwInput(const GlfwInput&) = delete;
  GlfwInput& operator=(const GlfwInput&) = delete;
};

/// Wakes the window when an interrupt has cancelled the progress: a signal alone does not end its wait for
/// events.
class InterruptWatch {
 public:
  explicit InterruptWatch(const Progress& progress)
      : thread_([&progress](const std::stop_token& stop) {
          while (!stop.stop_requested() && !progress.cancelled()) std::this_thread::sleep_for(k_period);
          glfwPostEmptyEvent();
        }) {}

 private:
  static constexpr std::chrono::milliseconds k_period{100};
  std::jthread thread_;
};

/// Sleeps until there is an event or the time has come.
void wait_for_events(double next_frame_s) {
  const double left_s = next_frame_s - glfwGetTime();
  if (left_s <= 0.0) {
    glfwPollEvents();
  } else if (left_s > 3600.0) {
    glfwWaitEvents();
  } else {
    glfwWaitEventsTimeout(left_s);
  }
}

/// A key that was pressed and released between two frames counts as held in the frame that comes: ImGui's
/// older backends would miss it. `down` before that frame, up after it.
void hold_short_presses([[maybe_unused]] GLFWwindow* window,
                        [[maybe_unused]] const std::vector<KeyPress>& keys, [[maybe_unused]] bool down) {
#if IMGUI_VERSION_NUM < 18700
  for (const KeyPress& press : keys) {
    if (glfwGetKey(window, press.key) != GLFW_PRESS) ImGui::GetIO().KeysDown[press.key] = down;
  }
#endif
}

std::unique_ptr<WindowContext> create_window() {
  try {
    return std::make_unique<WindowContext>();
  } catch (const Error& error) {
    throw Error(fmt::format("no window with OpenGL 3.3 ({}); {}", error.what(), k_headless_advice));
  }
}

AppOptions app_options(const WindowOptions& options) {
  AppOptions app;
  app.persistent = true;
  app.reading = options.reading;
  app.user = load_user_state();
  set_options(window_options(), app.user.window, options.window);
  app.shipped_parts = shipped_parts();
  app.wake = [] { glfwPostEmptyEvent(); };
  app.make_context = create_context;
  return app;
}

void save_picture(App& app, WindowContext& context, const std::string& path) {
  const glm::ivec2 size = context.framebuffer_size();
  try {
    write_picture(path, size, gl::read_colours(context.functions(), 0, size));
    app.say(fmt::format("Picture saved as {}", path), false);
  } catch (const Error& error) {
    app.say(error.what(), true);
  }
}

void run_frames(App& app, WindowContext& context, const Progress& progress) {
  std::string title;
  while (glfwWindowShouldClose(context.window()) == GLFW_FALSE && !app.quitting()) {
    wait_for_events(app.next_frame_s());
    if (progress.cancelled()) return;
    const glm::ivec2 size = context.framebuffer_size();
    if (size.x <= 0 || size.y <= 0) {
      glfwWaitEvents();  // minimised
      continue;
    }
    WindowContext::Events events = context.take_events();
    const FrameInput input{.size = size,
                           .content_scale = context.content_scale(),
                           .now_s = glfwGetTime(),
                           .keys = std::move(events.keys),
                           .dropped = std::move(events.dropped)};
    app.prepare(input);
    ImGui_ImplGlfw_NewFrame();
    hold_short_presses(context.window(), input.keys, true);
    app.frame(input);
    hold_short_presses(context.window(), input.keys, false);
    app.draw({.framebuffer = 0, .size = size});
    if (const auto picture = app.take_picture_request()) save_picture(app, context, *picture);
    {
      const gl::Turn turn(context.draws_on_cpu());
      glfwSwapBuffers(context.window());
    }
    std::string wanted = app.state().model
                             ? std::filesystem::path(app.state().path).filename().string() + " – moldlight"
                             : "moldlight";
    if (wanted != title) glfwSetWindowTitle(context.window(), (title = std::move(wanted)).c_str());
  }
}

}  // namespace

void run_window(const WindowOptions& options, const Progress& progress) {
  auto glfw = std::make_unique<const GlfwLibrary>();
  auto context = create_window();
  std::string remark;
  if (const std::string fault = driver_fault(*context); !fault.empty()) {
    const std::string driver = context->renderer();
    context.reset();
    glfw.reset();
    // Mesa's own driver for machines without a graphics card, whatever is asked for.
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    glfw = std::make_unique<const GlfwLibrary>();
    context = create_window();
    if (!driver_fault(*context).empty()) throw Error(fmt::format("the driver {} {}", driver, fault));
    remark = fmt::format("The driver {} {}; {} draws in its place.", driver, fault, context->renderer());
  }
  App app(*context, app_options(options));
  const GlfwInput input(context->window());
  if (!remark.empty()) app.say(remark, true);
  if (options.notes) app.set_notes(*options.notes);
  if (!options.part.empty()) app.open(options.part);
  glfwShowWindow(context->window());
  const InterruptWatch watch(progress);
  run_frames(app, *context, progress);
  app.save();
  if (progress.cancelled()) throw Cancelled();
}

}  // namespace moldlight::gui
