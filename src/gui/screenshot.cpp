#include "gui/screenshot.hpp"

#include <algorithm>
#include <array>
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

using Json = nlohmann::json;

// What a script may ask for.
constexpr double k_farthest_px = 1e5, k_least_side_px = 240, k_most_side_px = 8192;
constexpr double k_most_notches = 1000, k_most_clicks = 100, k_longest_wait_s = 600;

constexpr std::pair<std::string_view, int> k_key_names[] = {
    {"Tab", GLFW_KEY_TAB},       {"Escape", GLFW_KEY_ESCAPE},
    {"Enter", GLFW_KEY_ENTER},   {"Left", GLFW_KEY_LEFT},
    {"Right", GLFW_KEY_RIGHT},   {"Up", GLFW_KEY_UP},
    {"Down", GLFW_KEY_DOWN},     {"F1", GLFW_KEY_F1},
    {"F12", GLFW_KEY_F12},       {"Backspace", GLFW_KEY_BACKSPACE},
    {"Delete", GLFW_KEY_DELETE},
};

int key_code(const std::string& name) {
  if (name.size() == 1) return std::toupper(static_cast<unsigned char>(name[0]));
  for (const auto& [known, code] : k_key_names) {
    if (known == name) return code;
  }
  throw UsageError(fmt::format("there is no key '{}'", name));
}

double number(const Json& json, double least, double most) {
  if (!json.is_number()) throw UsageError("there is a number missing");
  const auto value = json.get<double>();
  if (!(value >= least && value <= most))
    throw UsageError(fmt::format("{:g} is out of range, {:g} to {:g}", value, least, most));
  return value;
}

glm::vec2 pair(const Json& json, double least = -k_farthest_px, double most = k_farthest_px) {
  if (!json.is_array() || json.size() != 2) throw UsageError("write two numbers, [x, y]");
  return {number(json[0], least, most), number(json[1], least, most)};
}

glm::vec2 place_of_control(const std::string& text, const OffscreenWindow& window) {
  const std::size_t at = text.rfind('@');
  const ScreenBox control = window.control(text.substr(0, at));
  if (at == std::string::npos) return control.centre();
  const double share = parse_real({text.substr(at + 1), "the share of a control's width"});
  return {glm::mix(control.min.x, control.max.x, static_cast<float>(share)), control.centre().y};
}

glm::vec2 place(const Json& json, const OffscreenWindow& window) {
  if (json.is_string()) return place_of_control(json.get<std::string>(), window);
  return pair(json);
}

/// `whole` is the event, `value` what stands under its name.
struct Event {
  const Json &whole, &value;
  OffscreenWindow& window;
};

int button_of(const Event& event) {
  const std::string name = event.whole.value("button", "left");
  if (name == "left") return 0;
  if (name == "right") return 1;
  if (name == "middle") return 2;
  throw UsageError(fmt::format("there is no mouse button '{}'", name));
}

void click(const Event& event) {
  const int button = button_of(event);
  event.window.move_mouse(place(event.value, event.window));
  event.window.frames(2);
  const int times =
      event.whole.contains("times") ? static_cast<int>(number(event.whole["times"], 1, k_most_clicks)) : 1;
  for (int k = 0; k < times; ++k) {
    event.window.set_button(button, true);
    event.window.frame();
    event.window.set_button(button, false);
    event.window.frame();
  }
}

void drag(const Event& event) {
  const Json& path = event.value;
  OffscreenWindow& window = event.window;
  if (!path.is_array() || path.size() < 2) throw UsageError("a drag goes through two places at least");
  constexpr int k_steps = 6;  // frames from place to place
  const int button = button_of(event);
  glm::vec2 at = place(path[0], window);
  window.move_mouse(at);
  window.frames(3);
  window.set_button(button, true);
  window.frames(2);
  for (std::size_t k = 1; k < path.size(); ++k) {
    const glm::vec2 from = at, to = place(path[k], window);
    for (int step = 1; step <= k_steps; ++step) {
      at = from + (to - from) * (static_cast<float>(step) / k_steps);
      window.move_mouse(at);
      window.frame();
    }
  }
  if (event.whole.value("release", true)) window.set_button(button, false);
  window.frame();
}

void hold(const Event& event) {
  constexpr std::array<std::string_view, 3> k_names = {"ctrl", "shift", "alt"};
  std::array<bool, 3> held{};
  for (const Json& name : event.value) {
    const auto found = std::find(k_names.begin(), k_names.end(), name);
    if (found == k_names.end()) throw UsageError(fmt::format("there is no modifier {}", name.dump()));
    held[static_cast<std::size_t>(found - k_names.begin())] = true;
  }
  event.window.hold_modifiers(held[0], held[1], held[2]);
}

void wait(const Event& event) {
  if (event.value == "loaded") {
    event.window.wait_until_loaded();
  } else if (event.value == "swept") {
    event.window.wait_until_swept();
  } else if (event.value == "measured") {
    event.window.wait_until_measured();
  } else if (event.value.is_number()) {
    event.window.frames(static_cast<int>(std::lround(number(event.value, 0.0, k_longest_wait_s) * 60.0)));
  } else {
    throw UsageError("wait is \"loaded\", \"measured\", \"swept\" or a number of seconds");
  }
}

void press(const Event& event) {
  event.window.press_key({.key = key_code(event.value.get<std::string>()),
                          .ctrl = event.whole.value("ctrl", false),
                          .shift = event.whole.value("shift", false),
                          .alt = event.whole.value("alt", false)});
  event.window.frame();
  event.window.hold_modifiers(false, false, false);
}

void turn_wheel(const Event& event) {
  if (event.whole.contains("at")) event.window.move_mouse(place(event.whole["at"], event.window));
  event.window.frames(2);
  event.window.turn_wheel(static_cast<float>(number(event.value, -k_most_notches, k_most_notches)));
  event.window.frame();
}

struct EventKind {
  std::string_view name;
  void (*act)(const Event& event);
  bool settles = true;  // what it does is to be seen before the next event
};
constexpr EventKind k_events[] = {
    {"move", [](const Event& e) { e.window.move_mouse(place(e.value, e.window)); }},
    {"click", click},
    {"drag", drag},
    {"wheel", turn_wheel},
    {"key", press},
    {"type", [](const Event& e) { e.window.type(e.value.get<std::string>()); }},
    {"hold", hold, false},
    {"open", [](const Event& e) { e.window.app().open(e.value.get<std::string>()); }, false},
    {"drop", [](const Event& e) { e.window.drop(e.value.get<std::string>()); }},
    {"resize",
     [](const Event& e) { e.window.resize(glm::ivec2(pair(e.value, k_least_side_px, k_most_side_px))); }},
    {"scale",
     [](const Event& e) { e.window.set_content_scale(static_cast<float>(number(e.value, 0.5, 4.0))); }},
    {"wait", wait, false},
    {"screenshot",
     [](const Event& e) { write_picture(e.value.get<std::string>(), e.window.size(), e.window.pixels()); },
     false},
};

void play(const Json& event, OffscreenWindow& window) {
  if (!event.is_object()) throw UsageError("an event is an object");
  for (const EventKind& kind : k_events) {
    if (!event.contains(kind.name)) continue;
    kind.act({event, event[kind.name], window});
    if (kind.settles) window.settle();
    return;
  }
  throw UsageError("there is no such event");
}

}  // namespace

void play_script(std::string_view text, OffscreenWindow& window) {
  const Json events = parse_json(text);
  if (!events.is_array() || events.empty()) throw UsageError("--script: not a JSON list of events");
  for (const Json& event : events) {
    try {
      play(event, window);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("--script: {}: {}", event.dump(), error.what()));
    } catch (const Json::exception&) {
      throw UsageError(fmt::format("--script: {}: a value has the wrong type", event.dump()));
    }
  }
}

void take_screenshot(const ScreenshotOptions& options) {
  OffscreenWindow window(options.window);
  if (options.notes) window.app().set_notes(*options.notes);
  if (!options.part.empty()) {
    window.app().open(options.part);
    window.wait_until_loaded();
    if (!window.state().model) {
      throw Error(window.state().toasts.empty() ? options.part + ": cannot be loaded"
                                                : window.state().toasts.back().text);
    }
    window.wait_until_measured();
  } else {
    window.wait_until_prepared();
  }
  if (options.script) {
    play_script(*options.script, window);
    window.wait_until_measured();
  }
  window.settle();
  write_picture(options.output, window.size(), window.pixels());
}

}  // namespace moldlight::gui
