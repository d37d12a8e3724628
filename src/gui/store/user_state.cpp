#include "gui/store/user_state.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/json.hpp"
#include "classify/option_json.hpp"
#include "gui/store/files.hpp"

namespace moldlight::gui {

namespace {

constexpr std::size_t k_recent_limit = 12;

constexpr std::pair<std::string_view, Hint> k_hint_names[] = {
    {"arrow", Hint::arrow}, {"verdict", Hint::verdict}, {"sweep", Hint::sweep}, {"tour", Hint::tour}};

/// What another version wrote and this one does not know keeps its default.
template <typename Settings>
void set_known_options(std::span<const Option<Settings>> options, Settings& settings, const Json& json) {
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    try {
      set_options(options, settings, Json{{key, value}});
    } catch (const UsageError&) {
    }
  }
}

}  // namespace

std::span<const Option<WindowSettings>> window_options() {
  using S = WindowSettings;
  static const std::vector<Option<S>> k_options = {
      {"theme", "--theme", "Theme", "", "Theme of the window.",
       moldlight::choice<&S::theme>({"dark", "light"})},
      {"ui_scale", "--ui-scale", "Size", "", "Size of text and panels, relative to the monitor's scale.",
       RealKind<S>{&S::ui_scale, 0.5, 3.0, 0.05}},
      {"navigation", "--navigation", "Navigation", "", "Mouse buttons for turning, shifting and zooming.",
       moldlight::choice<&S::navigation>({"standard", "solidworks", "fusion", "blender"})},
      {"motion", "--motion", "Motion", "", "Animate camera flights and fades.", SwitchKind<S>{&S::motion}},
      {"auto_reload", "--auto-reload", "Reload", "", "Read the part again when its file changes.",
       SwitchKind<S>{&S::auto_reload}},
      {"quick_sweep", "--quick-sweep", "Sweep", "",
       "Find the best directions once a part is loaded, and again when settings change.",
       SwitchKind<S>{&S::quick_sweep}},
      {"halves", "--halves", "Halves", "",
       "Show an opened mold as the part's surface moved apart, as steel halves, or as transparent halves. "
       "While the Mold panel is open, sections cut the closed mold, too.",
       moldlight::choice<&S::halves>({"surface", "solid", "clear"})},
  };
  return k_options;
}

void UserState::remember(const std::string& path) {
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > k_recent_limit) recent.resize(k_recent_limit);
}

std::string user_state_json(const UserState& state) {
  Json json;
  json["settings"] = options_json(window_options(), state.window);
  json["sweep"] = options_json(sweep_options(), state.sweep);
  json["recent"] = state.recent;
  json["hints_done"] = Json::array();
  for (const auto& [name, hint] : k_hint_names)
    if (state.hints_done.contains(hint)) json["hints_done"].push_back(name);
  return json.dump(2) + "\n";
}

UserState parse_user_state(std::string_view text) {
  const Json json = parse_json(text);
  if (!json.is_object()) throw UsageError("the saved window settings are not a JSON object");
  UserState state;
  if (json.contains("settings")) set_known_options(window_options(), state.window, json["settings"]);
  if (json.contains("sweep")) set_known_options(sweep_options(), state.sweep, json["sweep"]);
  if (json.contains("recent") && json["recent"].is_array()) {
    for (const Json& path : json["recent"]) {
      if (path.is_string() && state.recent.size() < k_recent_limit)
        state.recent.push_back(path.get<std::string>());
    }
  }
  if (json.contains("hints_done")) {
    for (const auto& [name, hint] : k_hint_names) {
      const Json& done = json["hints_done"];
      if (std::find(done.begin(), done.end(), name) != done.end()) state.hints_done.insert(hint);
    }
  }
  return state;
}

UserState load_user_state() {
  const auto folder = state_folder();
  if (!folder) return {};
  UserState state;
  try {
    if (const auto text = read_text(*folder / "window.json")) state = parse_user_state(*text);
  } catch (const Error&) {
    state = {};
  }
  if (auto layout = read_text(*folder / "imgui.ini")) state.layout = std::move(*layout);
  return state;
}

void save_user_state(const UserState& state) {
  const auto folder = state_folder();
  if (!folder) return;
  write_text(*folder / "window.json", user_state_json(state));
  if (!state.layout.empty()) write_text(*folder / "imgui.ini", state.layout);
}

}  // namespace moldlight::gui
