// Recorded input: a JSON list of events that is played to the window without a display.
#pragma once

#include <string>
#include <string_view>

#include "gui/offscreen.hpp"

namespace moldlight::gui {

/// Plays the events in order. Each is an object with one of these:
///   {"move": [x, y]}  {"click": [x, y], "button": "left", "times": 1}
///   {"drag": [[x, y], [x, y], …], "button": "left"}  {"wheel": notches, "at": [x, y]}
///   {"key": "F", "ctrl": true, "shift": true, "alt": true}  {"type": "text"}  {"hold": ["ctrl"]}
///   {"open": "path"}  {"drop": "path"}  {"resize": [w, h]}  {"scale": 2}
///   {"wait": "loaded" | "measured" | "swept" | seconds}  {"screenshot": "out.png"}
/// A place is [x, y] in pixels from the upper left corner, or the name of a control: its label, "label=word"
/// for the word of a choice, "label@0.3" for a place at that share of its width. Throws UsageError that names
/// the event and what is wrong.
void play_script(std::string_view json, OffscreenWindow& window);

}  // namespace moldlight::gui
