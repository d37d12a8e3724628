// The window on the desktop (GLFW): waits for events, draws when something changed.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "base/progress.hpp"
#include "classify/json.hpp"
#include "gui/app_state.hpp"
#include "io/read_options.hpp"

namespace moldlight::gui {

struct WindowOptions {
  std::string part;          // empty: the start page
  std::string compare = {};  // another revision beside it; empty: none
  ReadOptions reading;
  std::optional<PartNotes> notes;  // settings given on the command line
  /// Keys of window_options() given there, with their values: they hold this time, and are not remembered.
  Json window = Json::object();
  std::string remark = {};  // to the user, at the beginning
  std::function<void(const AppState&)> after_frame = {};
};

/// Runs until the window is closed, or `progress` cancelled: then it saves what is to be remembered and
/// throws Cancelled. Throws Error that names the commands which need no window, where there is no display or
/// no OpenGL.
void run_window(const WindowOptions& options, const Progress& progress);

}  // namespace moldlight::gui
