// How the window looks and behaves for its user, with its table of options.
#pragma once

#include <cstdint>
#include <span>

#include "classify/look_options.hpp"
#include "render/view_settings.hpp"

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

}  // namespace moldlight::gui
