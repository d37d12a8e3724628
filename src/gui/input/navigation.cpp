#include "gui/input/navigation.hpp"

namespace moldlight::gui {

namespace {

Gesture middle_gesture(NavigationPreset preset, const Modifiers& held) {
  switch (preset) {
    case NavigationPreset::solidworks:
      return held.ctrl ? Gesture::pan : held.shift ? Gesture::zoom : Gesture::orbit;
    case NavigationPreset::fusion:
      return held.shift ? Gesture::orbit : held.ctrl ? Gesture::zoom : Gesture::pan;
    case NavigationPreset::blender:
      return held.shift ? Gesture::pan : held.ctrl ? Gesture::zoom : Gesture::orbit;
    case NavigationPreset::standard:
      break;
  }
  return Gesture::pan;
}

}  // namespace

Gesture gesture_of(NavigationPreset preset, MouseButton button, const Modifiers& held) {
  switch (button) {
    case MouseButton::middle:
      return middle_gesture(preset, held);
    case MouseButton::right:
      return preset == NavigationPreset::standard ? Gesture::pan : Gesture::none;
    case MouseButton::left:
      break;
  }
  // A laptop without a middle button can still turn the part, whatever the preset.
  if (held.shift) return Gesture::pan;
  return Gesture::orbit;
}

}  // namespace moldlight::gui
