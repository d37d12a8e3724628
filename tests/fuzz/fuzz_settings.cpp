// JSON of settings: a part's notes, what the window remembers of its user, and an object for every table of
// options. What is taken must come back the same after it was written.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "gui/store/files.hpp"
#include "gui/store/part_notes.hpp"
#include "gui/store/user_state.hpp"

using namespace moldlight;

namespace {

/// Calls read(), which may refuse by a UsageError of one line.
template <typename Read>
void taken_or_refused(const Read& read) {
  try {
    read();
  } catch (const UsageError& error) {
    CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}

template <typename Settings>
void check_options(std::span<const Option<Settings>> options, const nlohmann::ordered_json& json) {
  taken_or_refused([&] {
    Settings settings;
    set_options(options, settings, json);
    const nlohmann::ordered_json written = options_json(options, settings);
    Settings again;
    set_options(options, again, written);
    CHECK(options_json(options, again) == written);
  });
}

void check_notes(std::string_view text) {
  taken_or_refused([&] {
    const gui::PartNotes notes = gui::parse_part_notes(text, {});
    const gui::PartNotes again = gui::parse_part_notes(gui::part_notes_json(notes, "part.stl"), {});
    CHECK(again.settings == notes.settings);
    CHECK(again.bookmarks.size() == notes.bookmarks.size());
    for (std::size_t k = 0; k < notes.bookmarks.size(); ++k) {
      const glm::dvec3& direction = notes.bookmarks[k].direction;
      CHECK(again.bookmarks[k].note == notes.bookmarks[k].note);
      CHECK(std::abs(glm::length(direction) - 1.0) < 1e-11);
      CHECK(glm::distance(again.bookmarks[k].direction, direction) < 1e-11);
    }
  });
}

void check_user_state(std::string_view text) {
  taken_or_refused([&] {
    const gui::UserState state = gui::parse_user_state(text);
    const std::string written = gui::user_state_json(state);
    CHECK(gui::user_state_json(gui::parse_user_state(written)) == written);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_notes(text);
  check_user_state(text);
  if (const auto json = gui::parse_json(text); json.is_object()) {
    check_options(method_options(), json);
    check_options(reading_options(), json);
    check_options(look_options(), json);
    check_options(sweep_options(), json);
    check_options(gui::window_options(), json);
  }
  return 0;
}
