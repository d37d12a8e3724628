#include "gui/window.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "gl/colour_target.hpp"
#include "gui/advice.hpp"
#include "gui/app.hpp"
#include "gui/picture_file.hpp"
#include "gui/shipped_parts.hpp"
#include "gui/window_context.hpp"
#include "session/headless.hpp"
#include "session/option_table.hpp"

namespace moldlight::gui {

namespace {

constexpr glm::ivec2 k_first_size(1280, 800);

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
/// older backends would miss it.
class ShortPresses {
 public:
  ShortPresses([[maybe_unused]] GLFWwindow* window, [[maybe_unused]] const std::vector<KeyPress>& keys) {
#if IMGUI_VERSION_NUM < 18700
    for (const KeyPress& press : keys) {
      if (glfwGetKey(window, press.key) == GLFW_PRESS) continue;
      ImGui::GetIO().KeysDown[press.key] = true;
      released_.push_back(press.key);
    }
#endif
  }
  ~ShortPresses() {
#if IMGUI_VERSION_NUM < 18700
    for (const int key : released_) ImGui::GetIO().KeysDown[key] = false;
#endif
  }
  ShortPresses(const ShortPresses&) = delete;
  ShortPresses& operator=(const ShortPresses&) = delete;

 private:
  std::vector<int> released_;
};

std::unique_ptr<WindowContext> create_window() {
  try {
    return std::make_unique<WindowContext>(k_first_size, "moldlight");
  } catch (const Error& error) {
    throw Error(fmt::format("no window with OpenGL 3.3 ({}); {}", error.what(), k_headless_advice));
  }
}

std::unique_ptr<GlfwLibrary> start_glfw() {
  try {
    return std::make_unique<GlfwLibrary>();
  } catch (const Error& error) {
    throw Error(fmt::format("no display to open a window on ({}); {}", error.what(), k_headless_advice));
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
    {
      const ShortPresses presses(context.window(), input.keys);
      app.frame(input);
    }
    app.draw({.framebuffer = 0, .size = size});
    if (const auto picture = app.take_picture_request()) save_picture(app, context, *picture);
    context.present();
    std::string wanted = app.state().model
                             ? std::filesystem::path(app.state().path).filename().string() + " – moldlight"
                             : "moldlight";
    if (wanted != title) context.set_title(title = std::move(wanted));
  }
}

}  // namespace

void run_window(const WindowOptions& options, const Progress& progress) {
  const auto glfw = start_glfw();
  const auto context = create_window();
  App app(*context, app_options(options));
  const GlfwInput input(context->window());
  if (options.notes) app.set_notes(*options.notes);
  if (!options.part.empty()) app.open(options.part);
  context->show();
  const InterruptWatch watch(progress);
  run_frames(app, *context, progress);
  app.save();
  if (progress.cancelled()) throw Cancelled();
}

}  // namespace moldlight::gui
