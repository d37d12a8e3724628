// Key presses as the window and recorded input deliver them.
#pragma once

namespace moldlight::gui {

/// `key` is GLFW's code, which is ASCII's upper case for letters and digits.
struct KeyPress {
  int key = 0;
  bool ctrl = false, shift = false, alt = false;
};

}  // namespace moldlight::gui
