// Recorded input for the window: a JSON list of events, which is read as a whole before any of it is played.
// And the window's picture after it, without a display.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/store/part_notes.hpp"
#include "replay/offscreen.hpp"

namespace moldlight::gui {

struct ScriptEvent {
  std::string text;  // as it was written
  std::function<void(OffscreenWindow&)> play;
};
using Script = std::vector<ScriptEvent>;

/// Reads the events. Each is an object with one of these:
///   {"move": [x, y]}  {"click": [x, y], "button": "left", "times": 1}
///   {"drag": [[x, y], [x, y], …], "button": "left"}  {"wheel": notches, "at": [x, y]}
///   {"key": "F", "ctrl": true, "shift": true, "alt": true}  {"type": "text"}  {"hold": ["ctrl"]}
///   {"open": "path"}  {"drop": "path"}  {"resize": [w, h]}  {"scale": 2}
///   {"wait": "loaded" | "measured" | "swept" | seconds}  {"screenshot": "out.png"}
///   {"hints": true}
/// A place is [x, y] in pixels from the upper left corner, or the name of a control: its label, "label=word"
/// for the word of a choice, "label@0.3" for a place at that share of its width, 0 to 1. Throws UsageError
/// that names the event and what is wrong: a scale beyond 0.5 to 4, a wait of more than 600 s, a list without
/// events.
[[nodiscard]] Script parse_script(std::string_view json);

/// Plays the events in order. Throws UsageError that names the event: there is no control of that name.
void play_script(const Script& script, OffscreenWindow& window);

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
