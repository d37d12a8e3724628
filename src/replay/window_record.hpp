// What the window notes of itself, for the one that takes its place after a crash.
#pragma once

#include <string>
#include <string_view>

#include "gui/app_state.hpp"

namespace moldlight::gui {

struct WindowRecord {
  std::string part = {}, compare = {};  // paths; empty: none
  std::string work = {};                // what goes on behind, as it follows "while it"; empty: nothing
  std::string part_at_work = {};        // of which it is
  /// What went on behind when the window before this one crashed, and of which part.
  std::string former_work = {}, former_part = {};

  bool operator==(const WindowRecord&) const = default;
};

[[nodiscard]] WindowRecord record_of(const AppState& state);
[[nodiscard]] std::string record_text(const WindowRecord& record);
/// Empty where the text says nothing.
[[nodiscard]] WindowRecord parse_record(std::string_view text);

/// What the next window does.
struct Resumed {
  WindowRecord opened = {};  // part, compare: to be opened; former_…: as of the crash
  std::string said = {};     // to the user, in one or two sentences
};
/// After a crash by `cause`. A part is not opened again by itself where reading it was the cause, or the same
/// work crashed twice.
[[nodiscard]] Resumed resume(const WindowRecord& crashed, const std::string& cause);

}  // namespace moldlight::gui
