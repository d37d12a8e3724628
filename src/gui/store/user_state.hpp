// What the window remembers of its user: settings, recent files, places of the panels.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gui/store/settings.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight::gui {

/// What a newcomer is asked to do, in this order.
enum class Hint : std::uint8_t { arrow, verdict, sweep };

struct UserState {
  WindowSettings window;
  std::vector<std::string> recent;  // absolute paths, the latest first
  SweepSettings sweep;              // options of the next sweep
  std::set<Hint> hints_done;        // not to be shown any more
  std::string layout;               // as imgui.ini; empty for the shipped one

  /// Puts a path in front of the recent ones and forgets the oldest of more than twelve.
  void remember(const std::string& path);
};

/// JSON of everything but the layout.
[[nodiscard]] std::string user_state_json(const UserState& state);
/// Throws UsageError for text that is no such JSON; settings that this version does not know are passed over.
[[nodiscard]] UserState parse_user_state(std::string_view json);

/// What was saved; the defaults where nothing was or it cannot be read.
[[nodiscard]] UserState load_user_state();
/// Throws FileError; does nothing where there is no folder for it.
void save_user_state(const UserState& state);

}  // namespace moldlight::gui
