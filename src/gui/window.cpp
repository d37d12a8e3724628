#include "gui/window.hpp"

#include <filesystem>
#include <memory>

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

void run_frames(App& app, WindowContext& context) {
  std::string title;
  while (glfwWindowShouldClose(context.window()) == GLFW_FALSE) {
    wait_for_events(app.next_frame_s());
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
    app.frame(input);
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

void run_window(const WindowOptions& options) {
  const auto glfw = start_glfw();
  const auto context = create_window();
  App app(*context, app_options(options));
  const GlfwInput input(context->window());
  if (options.notes) app.set_notes(*options.notes);
  if (!options.part.empty()) app.open(options.part);
  context->show();
  run_frames(app, *context);
  app.save();
}

}  // namespace moldlight::gui
