// Input events of the window: kept in order, with the place and the time of each event, and given to ImGui
// so that slow frames lose nothing of it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "gui/draw/keyboard.hpp"

struct ImGuiIO;

namespace moldlight::gui {

/// A key press. `key` is GLFW's code, which is ASCII's upper case for letters and digits.
struct KeyPress {
  int key = 0;
  bool ctrl = false, shift = false, alt = false;
};

/// What the key asks of controls; none for all others, and with Ctrl or Alt.
[[nodiscard]] ControlKey control_key(const KeyPress& press);

/// Events go in as they come; a frame takes as many of them as act as they would in frames of their own: a
/// run of mouse moves, or one change of a button, or one press of a key, … The rest waits for the next frame.
class InputQueue {
 public:
  /// Times are seconds that never fall. Places are pixels of the window, y down; `button` is ImGui's.
  void move_mouse(double time_s, const glm::vec2& to) {
    add({.kind = Kind::move, .time_s = time_s, .at = to});
  }
  void mouse_left(double time_s) { move_mouse(time_s, k_nowhere); }
  void set_button(double time_s, int button, bool down) {
    add({.kind = Kind::button, .time_s = time_s, .code = button, .down = down});
  }
  void turn_wheel(double time_s, float notches) {
    add({.kind = Kind::wheel, .time_s = time_s, .at = {0.0F, notches}});
  }
  /// A key that repeats is pressed again without a release.
  void press_key(double time_s, const KeyPress& press) {
    add({.kind = Kind::press, .time_s = time_s, .code = press.key, .press = press});
  }
  void release_key(double time_s, int key) { add({.kind = Kind::release, .time_s = time_s, .code = key}); }
  void hold_modifiers(double time_s, bool ctrl, bool shift, bool alt) {
    add({.kind = Kind::modifiers, .time_s = time_s, .press = {.ctrl = ctrl, .shift = shift, .alt = alt}});
  }
  void type(double time_s, std::string_view utf8) {
    add({.kind = Kind::text, .time_s = time_s, .text = std::string(utf8)});
  }

  /// What a frame has taken.
  struct Played {
    std::vector<KeyPress> keys;
    bool any = false;
  };
  /// Gives ImGui the input of the frame that begins at `now_s`. ImGui's clock follows that of the events, so
  /// that two clicks are a double click by the time between them, however long frames take.
  Played play(ImGuiIO& io, double now_s);
  [[nodiscard]] bool empty() const { return events_.empty(); }

 private:
  static constexpr glm::vec2 k_nowhere{-1.0e6F};
  enum class Kind : std::uint8_t { move, button, wheel, press, release, modifiers, text };
  struct Event {
    Kind kind;
    double time_s;
    glm::vec2 at{0.0F};  // of the mouse; wheel: notches in y
    int code = 0;        // of a button or key
    bool down = false;
    KeyPress press = {};
    std::string text = {};
  };
  /// Whether it can share a frame with what the frame has taken, the last of which is `former`. `typing`: a
  /// text field listens.
  [[nodiscard]] static bool joins(const Event& event, const Event& former, bool typing);
  void act(const Event& event, ImGuiIO& io, Played& played);
  void add(Event event) { events_.push_back(std::move(event)); }

  std::deque<Event> events_;
  glm::vec2 mouse_ = k_nowhere;
  std::array<bool, 3> buttons_{};
  double clock_s_ = 0.0;
};

}  // namespace moldlight::gui
