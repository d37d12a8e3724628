#include "gui/window.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/owned.hpp"
#include "base/shown_text.hpp"
#include "classify/headless.hpp"
#include "classify/option_json.hpp"
#include "gl/headless_backends.hpp"
#include "gl/headless_context.hpp"
#include "gl/objects.hpp"
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

/// GLFW's window with its OpenGL context, and its keys and dropped files.
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
    const gl::SoftwareGlLock turn(true);
    window_ = glfwCreateWindow(k_first_size.x, k_first_size.y, "moldlight", nullptr, nullptr);
    if (window_ == nullptr) throw Error(glfw_reason());
    glfwSetWindowSizeLimits(window_, 720, 450, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, &events_);
    listen();
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
    const gl::SoftwareGlLock turn(draws_on_cpu());
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

  /// What came and was not taken yet.
  struct Events {
    InputQueue input;
    std::vector<std::string> dropped;
  };
  [[nodiscard]] Events& events() { return events_; }

 private:
  static Events& events_of(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
  }
  void listen();
  void bind() override { glfwMakeContextCurrent(window_); }
  void unbind() noexcept override { glfwMakeContextCurrent(nullptr); }

  GLFWwindow* window_ = nullptr;
  Events events_;
};

void WindowContext::listen() {
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    events_of(window).input.move_mouse(glfwGetTime(), glm::vec2(x, y));
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
    // A drag goes on outside.
    const auto held = [&](int button) { return glfwGetMouseButton(window, button) == GLFW_PRESS; };
    if (entered == GLFW_FALSE && !held(0) && !held(1) && !held(2))
      events_of(window).input.mouse_left(glfwGetTime());
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
    if (button <= GLFW_MOUSE_BUTTON_MIDDLE)
      events_of(window).input.set_button(glfwGetTime(), button, action == GLFW_PRESS);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double notches) {
    events_of(window).input.turn_wheel(glfwGetTime(), static_cast<float>(notches));
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
    InputQueue& input = events_of(window).input;
    const double now_s = glfwGetTime();
    if (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) {
      // What GLFW says of modifiers is from before this key.
      const auto held = [&](int left, int right) {
        return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
      };
      input.hold_modifiers(now_s, held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                           held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                           held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT));
    } else if (action == GLFW_RELEASE) {
      input.release_key(now_s, key);
    } else if (key != GLFW_KEY_UNKNOWN) {
      input.press_key(now_s, {.key = key,
                              .ctrl = (modifiers & GLFW_MOD_CONTROL) != 0,
                              .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                              .alt = (modifiers & GLFW_MOD_ALT) != 0});
    }
  });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned letter) {
    events_of(window).input.type(glfwGetTime(), utf8_of(std::u32string(1, letter)));
  });
}

/// Wakes the window when the progress is cancelled: a signal alone does not end its wait for events.
class InterruptWatch {
 public:
  explicit InterruptWatch(const Progress& progress)
      : thread_([&progress](const std::stop_token& stop) {
          while (!stop.stop_requested() && !progress.cancelled())
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
          glfwPostEmptyEvent();
        }) {}

 private:
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

std::unique_ptr<WindowContext> create_window() try {
  return std::make_unique<WindowContext>();
} catch (const Error& error) {
  throw Error(fmt::format("no window with OpenGL 3.3 ({}); {}", error.what(), k_headless_advice));
}

AppOptions app_options(const WindowOptions& options) {
  AppOptions app;
  app.persistent = true;
  app.reading = options.reading;
  app.user = load_user_state();
  app.window = app.user.window;
  set_options(window_options(), *app.window, options.window);
  app.shipped_parts = shipped_parts();
  app.rehearses = true;
  app.wake = [] { glfwPostEmptyEvent(); };
  app.make_context = create_context;
  return app;
}

void save_picture(App& app, WindowContext& context, const std::string& path) {
  const glm::ivec2 size = context.framebuffer_size();
  if (app.attempt([&] { write_picture(path, size, gl::read_colours(context.functions(), 0, size)); }))
    app.picture_saved(path);
}

void run_frames(App& app, WindowContext& context, const WindowOptions& options, const Progress& progress) {
  std::string title;
  while (true) {
    WindowContext::Events& events = context.events();
    wait_for_events(events.input.empty() ? app.next_frame_s() : 0.0);
    // Not after one more frame, which takes long with a large part.
    if (progress.cancelled() || glfwWindowShouldClose(context.window()) == GLFW_TRUE) return;
    const glm::ivec2 size = context.framebuffer_size();
    if (size.x <= 0 || size.y <= 0) {
      glfwWaitEvents();  // minimised
      continue;
    }
    FrameInput input{.size = size,
                     .content_scale = context.content_scale(),
                     .now_s = glfwGetTime(),
                     .played = {},
                     .dropped = std::exchange(events.dropped, {})};
    app.prepare(input);
    ImGui_ImplGlfw_NewFrame();
    input.played = events.input.play(ImGui::GetIO(), input.now_s);
    app.frame(input);
    if (app.quitting()) return;
    if (options.after_frame) options.after_frame(app.state());
    app.draw({.framebuffer = 0, .size = size});
    if (const auto picture = app.take_picture_request()) save_picture(app, context, *picture);
    {
      const gl::SoftwareGlLock turn(context.draws_on_cpu());
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
  std::string remark = options.remark;
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
  // GLFW's side of ImGui: size, clipboard, cursors. Input comes through the queue.
  ImGui_ImplGlfw_InitForOpenGL(context->window(), false);
  const Owned<GLFWwindow, [](GLFWwindow*) { ImGui_ImplGlfw_Shutdown(); }> platform(context->window());
  app.show_hints(true);
  if (!remark.empty()) app.say(remark, true);
  if (options.notes) app.set_notes(*options.notes);
  options.part.empty() ? app.offer_tour() : app.open(options.part);
  if (!options.compare.empty()) app.compare_with(options.compare);
  glfwShowWindow(context->window());
  const InterruptWatch watch(progress);
  run_frames(app, *context, options, progress);
  // What goes on behind may take a while to end: nobody is to look at a window that no longer answers.
  glfwHideWindow(context->window());
  glfwPollEvents();
  app.end_jobs();
  app.save();
  if (progress.cancelled()) throw Cancelled();
}

}  // namespace moldlight::gui
