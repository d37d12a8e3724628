#include "replay/script.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/option.hpp"
#include "gui/store/files.hpp"

namespace moldlight::gui {

namespace {

using PlainJson = nlohmann::json;
using Play = std::function<void(OffscreenWindow&)>;

// What a script may ask for.
constexpr double k_farthest_px = 1e5, k_least_side_px = 240, k_most_side_px = 8192;
constexpr double k_most_notches = 1000, k_most_clicks = 100, k_longest_wait_s = 600;

constexpr std::pair<std::string_view, int> k_key_names[] = {
    {"Tab", GLFW_KEY_TAB},
    {"Escape", GLFW_KEY_ESCAPE},
    {"Enter", GLFW_KEY_ENTER},
    {"Left", GLFW_KEY_LEFT},
    {"Right", GLFW_KEY_RIGHT},
    {"Up", GLFW_KEY_UP},
    {"Down", GLFW_KEY_DOWN},
    {"F1", GLFW_KEY_F1},
    {"F5", GLFW_KEY_F5},
    {"F12", GLFW_KEY_F12},
    {"Backspace", GLFW_KEY_BACKSPACE},
    {"Delete", GLFW_KEY_DELETE},
};

int key_code(const std::string& name) {
  if (name.size() == 1) return std::toupper(static_cast<unsigned char>(name[0]));
  for (const auto& [known, code] : k_key_names)
    if (known == name) return code;
  throw UsageError(fmt::format("there is no key '{}'", name));
}

double number(const PlainJson& json, double least, double most) {
  if (!json.is_number()) throw UsageError("there is a number missing");
  const auto value = json.get<double>();
  if (!(value >= least && value <= most))
    throw UsageError(fmt::format("{:g} is out of range, {:g} to {:g}", value, least, most));
  return value;
}

glm::vec2 pair(const PlainJson& json, double least = -k_farthest_px, double most = k_farthest_px) {
  if (!json.is_array() || json.size() != 2) throw UsageError("write two numbers, [x, y]");
  return {number(json[0], least, most), number(json[1], least, most)};
}

/// A point of the window, or one of a control, which is looked for when the event is played.
struct Place {
  glm::vec2 at{0.0F};
  std::string control;  // empty: `at` it is
  float share = 0.5F;   // of the control's width

  [[nodiscard]] glm::vec2 in(const OffscreenWindow& window) const {
    if (control.empty()) return at;
    const ScreenBox box = window.control(control);
    return {glm::mix(box.min.x, box.max.x, share), box.centre().y};
  }
};

Place place(const PlainJson& json) {
  Place place;
  if (!json.is_string()) {
    place.at = pair(json);
    return place;
  }
  const auto text = json.get<std::string>();
  const std::size_t mark = text.rfind('@');
  place.control = text.substr(0, mark);
  if (place.control.empty()) throw UsageError("a control has a name");
  if (mark != std::string::npos) {
    place.share =
        static_cast<float>(parse_real({text.substr(mark + 1), "the share of a control's width"}, 0.0, 1.0));
  }
  return place;
}

/// `whole` is the event, `value` what stands under its name.
struct Event {
  const PlainJson &whole, &value;
};

int button_of(const Event& event) {
  const std::string name = event.whole.value("button", "left");
  if (name == "left") return 0;
  if (name == "right") return 1;
  if (name == "middle") return 2;
  throw UsageError(fmt::format("there is no mouse button '{}'", name));
}

Play move(const Event& event) {
  return [to = place(event.value)](OffscreenWindow& window) { window.move_mouse(to.in(window)); };
}

Play click(const Event& event) {
  const int times =
      event.whole.contains("times") ? static_cast<int>(number(event.whole["times"], 1, k_most_clicks)) : 1;
  return [button = button_of(event), at = place(event.value), times](OffscreenWindow& window) {
    window.move_mouse(at.in(window));
    window.frames(2);
    for (int k = 0; k < times; ++k) {
      window.set_button(button, true);
      window.frame();
      window.set_button(button, false);
      window.frame();
    }
  };
}

Play drag(const Event& event) {
  if (!event.value.is_array() || event.value.size() < 2)
    throw UsageError("a drag goes through two places at least");
  std::vector<Place> path;
  for (const PlainJson& json : event.value) path.push_back(place(json));
  const bool release = event.whole.value("release", true);
  return [button = button_of(event), path = std::move(path), release](OffscreenWindow& window) {
    constexpr int k_steps = 6;  // frames from place to place
    glm::vec2 at = path[0].in(window);
    window.move_mouse(at);
    window.frames(3);
    window.set_button(button, true);
    window.frames(2);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const glm::vec2 from = at, to = path[k].in(window);
      for (int step = 1; step <= k_steps; ++step) {
        at = from + (to - from) * (static_cast<float>(step) / k_steps);
        window.move_mouse(at);
        window.frame();
      }
    }
    if (release) window.set_button(button, false);
    window.frame();
  };
}

Play turn_wheel(const Event& event) {
  std::optional<Place> at;
  if (event.whole.contains("at")) at = place(event.whole["at"]);
  const auto notches = static_cast<float>(number(event.value, -k_most_notches, k_most_notches));
  return [at, notches](OffscreenWindow& window) {
    if (at) window.move_mouse(at->in(window));
    window.frames(2);
    window.turn_wheel(notches);
    window.frame();
  };
}

Play press(const Event& event) {
  const KeyPress key{.key = key_code(event.value.get<std::string>()),
                     .ctrl = event.whole.value("ctrl", false),
                     .shift = event.whole.value("shift", false),
                     .alt = event.whole.value("alt", false)};
  return [key](OffscreenWindow& window) {
    window.press_key(key);
    window.frame();
    window.hold_modifiers(false, false, false);
  };
}

Play hold(const Event& event) {
  constexpr std::array<std::string_view, 3> k_names = {"ctrl", "shift", "alt"};
  std::array<bool, 3> held{};
  for (const PlainJson& name : event.value) {
    const auto found = std::find(k_names.begin(), k_names.end(), name);
    if (found == k_names.end()) throw UsageError(fmt::format("there is no modifier {}", name.dump()));
    held[static_cast<std::size_t>(found - k_names.begin())] = true;
  }
  return [held](OffscreenWindow& window) { window.hold_modifiers(held[0], held[1], held[2]); };
}

Play resize(const Event& event) {
  const glm::ivec2 size(pair(event.value, k_least_side_px, k_most_side_px));
  return [size](OffscreenWindow& window) { window.resize(size); };
}

Play set_scale(const Event& event) {
  const auto scale = static_cast<float>(number(event.value, 0.5, 4.0));
  return [scale](OffscreenWindow& window) { window.set_content_scale(scale); };
}

Play wait(const Event& event) {
  if (event.value == "loaded") return &OffscreenWindow::wait_until_loaded;
  if (event.value == "swept") return &OffscreenWindow::wait_until_swept;
  if (event.value == "measured") return &OffscreenWindow::wait_until_measured;
  if (!event.value.is_number())
    throw UsageError("wait is \"loaded\", \"measured\", \"swept\" or a number of seconds");
  const auto frames = static_cast<int>(std::lround(number(event.value, 0.0, k_longest_wait_s) * 60.0));
  return [frames](OffscreenWindow& window) { window.frames(frames); };
}

Play show_hints(const Event& event) {
  return [shown = event.value.get<bool>()](OffscreenWindow& window) { window.app().show_hints(shown); };
}

/// An event whose value is a text alone.
template <void (*act)(OffscreenWindow&, const std::string&)>
Play with_text(const Event& event) {
  return [text = event.value.get<std::string>()](OffscreenWindow& window) { act(window, text); };
}
void type(OffscreenWindow& window, const std::string& text) { window.type(text); }
void drop(OffscreenWindow& window, const std::string& path) { window.drop(path); }
void open(OffscreenWindow& window, const std::string& path) { window.app().open(path); }
void compare(OffscreenWindow& window, const std::string& path) { window.app().compare_with(path); }
void write_screenshot(OffscreenWindow& window, const std::string& path) {
  write_picture(path, window.size(), window.pixels());
}

struct EventKind {
  std::string_view name;
  Play (*parse)(const Event& event);
  bool settles = true;  // what it does is to be seen before the next event
};
constexpr EventKind k_events[] = {
    {"move", move},
    {"click", click},
    {"drag", drag},
    {"wheel", turn_wheel},
    {"key", press},
    {"type", with_text<type>},
    {"hold", hold, false},
    {"open", with_text<open>, false},
    {"compare", with_text<compare>, false},
    {"drop", with_text<drop>},
    {"resize", resize},
    {"scale", set_scale},
    {"wait", wait, false},
    {"hints", show_hints},
    {"screenshot", with_text<write_screenshot>, false},
};

Play parse_event(const PlainJson& event) {
  if (!event.is_object()) throw UsageError("an event is an object");
  for (const EventKind& kind : k_events) {
    if (!event.contains(kind.name)) continue;
    const Play act = kind.parse({event, event[kind.name]});
    if (!kind.settles) return act;
    return [act](OffscreenWindow& window) {
      act(window);
      window.settle();
    };
  }
  throw UsageError("there is no such event");
}

UsageError complaint(const std::string& event, std::string_view what) {
  return UsageError(fmt::format("--script: {}: {}", event, what));
}

}  // namespace

Script parse_script(std::string_view text) {
  const PlainJson events = parse_json(text);
  if (!events.is_array() || events.empty()) throw UsageError("--script: not a JSON list of events");
  Script script;
  for (const PlainJson& event : events) {
    try {
      script.push_back({event.dump(), parse_event(event)});
    } catch (const UsageError& error) {
      throw complaint(event.dump(), error.what());
    } catch (const PlainJson::exception&) {
      throw complaint(event.dump(), "a value has the wrong type");
    }
  }
  return script;
}

void play_script(const Script& script, OffscreenWindow& window) {
  for (const ScriptEvent& event : script) {
    try {
      event.play(window);
    } catch (const UsageError& error) {
      throw complaint(event.text, error.what());
    }
  }
}

void take_screenshot(const ScreenshotOptions& options) {
  const Script script = options.script ? parse_script(*options.script) : Script();
  OffscreenWindow window(options.window);
  if (options.notes) window.app().set_notes(*options.notes);
  if (!options.part.empty()) {
    window.app().open(options.part);
    window.wait_until_loaded();
    if (!window.state().model && !window.state().batch) {
      throw Error(window.state().toasts.empty() ? options.part + ": cannot be loaded"
                                                : window.state().toasts.back().text);
    }
    if (!options.compare.empty()) window.app().compare_with(options.compare);
    window.wait_until_measured();
    if (!options.compare.empty() && !window.state().revisions.on())
      throw Error(window.state().toasts.back().text);
    if (window.app().sweeping()) window.wait_until_swept();
  } else {
    window.wait_until_prepared();
  }
  if (options.script) {
    play_script(script, window);
    window.wait_until_measured();
    if (window.app().sweeping()) window.wait_until_swept();
  }
  window.settle();
  write_picture(options.output, window.size(), window.pixels());
}

}  // namespace moldlight::gui
