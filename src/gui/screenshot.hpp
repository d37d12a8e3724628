// The window's picture without a display, after recorded input.
#pragma once

#include <optional>
#include <string>

#include "gui/offscreen.hpp"
#include "gui/store/part_notes.hpp"

namespace moldlight::gui {

struct ScreenshotOptions {
  std::string part;          // empty: the start page
  std::string compare = {};  // another revision beside it; empty: none
  std::string output;
  std::optional<std::string> script;  // JSON text
  std::optional<PartNotes> notes;
  OffscreenOptions window;
};

/// Loads and measures the part, plays the script and writes the last frame as PNG. Throws Error; a part that
/// cannot be loaded is one.
void take_screenshot(const ScreenshotOptions& options);

}  // namespace moldlight::gui
