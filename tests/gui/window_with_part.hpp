// The whole window on a context without a window, with a small part in it that has all four regions.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "gui/quick_options.hpp"

namespace moldlight::gui::test {

// Codes of keys that are no letters (GLFW's).
inline constexpr int k_escape = 256, k_enter = 257, k_tab = 258, k_right = 262, k_left = 263, k_up = 265,
                     k_f12 = 301;

/// The shipped layout has it folded up.
inline constexpr const char* k_look_unfolded = "[Window][Look]\nPos=996,360\nCollapsed=0\n";

/// Settings are quick ones: small maps, few samples. Motion is off.
class WindowWithPart : public ::testing::Test {
 protected:
  WindowWithPart() : window(options()) {
    PartNotes notes;
    notes.settings.method.resolution = 512;
    notes.settings.method.samples = 20'000;
    window.app().set_notes(notes);
    window.app().open(part.file());
    window.wait_until_loaded();
  }

  static OffscreenOptions options() {
    OffscreenOptions options = quick_options();
    options.size = {1280, 720};
    options.user.window.motion = options.user.window.quick_sweep = false;
    options.user.layout = k_look_unfolded;
    return options;
  }

  [[nodiscard]] const AppState& state() const { return window.state(); }
  [[nodiscard]] const MethodSettings& method() const { return state().settings.method; }
  [[nodiscard]] const glm::dvec3& direction() const { return state().settings.direction.given(); }

  void move_to(const glm::vec2& place) {
    window.move_mouse(place);
    window.frames(2);
  }
  void click(const std::string& control) {
    move_to(window.control(control).centre());
    press();
  }
  void press() {
    window.set_button(0, true);
    window.frame();
    window.set_button(0, false);
    window.frames(3);
  }
  void drag(const glm::vec2& from, const glm::vec2& to, bool release = true) {
    move_to(from);
    window.set_button(0, true);
    window.frames(2);
    for (int step = 1; step <= 4; ++step) {
      window.move_mouse(from + (to - from) * (0.25F * static_cast<float>(step)));
      window.frame();
    }
    if (release) window.set_button(0, false);
    window.frames(3);
  }
  /// Drags a slider to a share of its width.
  void slide(const std::string& control, float share) {
    const ScreenBox place = window.control(control);
    drag(place.centre(), {glm::mix(place.min.x, place.max.x, share), place.centre().y});
  }
  void key(const KeyPress& press) {
    window.press_key(press);
    window.frame();
    window.hold_modifiers(false, false, false);
    window.frames(3);
  }
  void undo() { key({.key = 'Z', .ctrl = true}); }
  /// By its key.
  void enter(Step step) { key({.key = '1' + static_cast<int>(step)}); }
  /// Opens the drawer of the shadow maps, or closes it.
  void turn_maps_drawer() {
    window.settle();  // where it stands once the window has its size
    click("fold maps");
    window.settle();
  }

  moldlight::test::SmallPart part;
  OffscreenWindow window;
};

}  // namespace moldlight::gui::test
