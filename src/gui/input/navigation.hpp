// Which mouse gesture turns, shifts and zooms, as in the programs that people come from.
#pragma once

#include <cstdint>

#include "gui/window_settings.hpp"

namespace moldlight::gui {

enum class Gesture : std::uint8_t { none, orbit, pan, zoom };
enum class MouseButton : std::uint8_t { left, right, middle };

struct Modifiers {
  bool ctrl = false, shift = false, alt = false;
};

[[nodiscard]] Gesture gesture_of(NavigationPreset preset, MouseButton button, const Modifiers& held);

}  // namespace moldlight::gui
