// The window's memory of its user: how it looks and behaves, with its table of options, recent files,
// places of the panels.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "classify/method_options.hpp"
#include "render/view_settings.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight::gui {

enum class NavigationPreset : std::uint8_t { standard, solidworks, fusion, blender };

/// How an opened mold, or one that is cut, is seen: as the part's own surface, or as the steel around the
/// part.
enum class HalvesLook : std::uint8_t { surface, solid, clear };

/// Whatever the part.
struct WindowSettings {
  Theme theme = Theme::dark;
  double ui_scale = 1.0;  // [0.5, 3], on top of the monitor's content scale
  NavigationPreset navigation = NavigationPreset::standard;
  bool motion = true;       // camera flights and fades
  bool auto_reload = true;  // when the part's file changes
  bool quick_sweep = true;  // after loading
  HalvesLook halves = HalvesLook::solid;

  bool operator==(const WindowSettings&) const = default;
};

[[nodiscard]] std::span<const Option<WindowSettings>> window_options();

/// What a newcomer is asked to do, in this order; the tour is offered before all else.
enum class Hint : std::uint8_t { arrow, verdict, sweep, tour };

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
