#include "replay/window_record.hpp"

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "base/shown_text.hpp"

namespace moldlight::gui {

namespace {

constexpr const char* k_reading = "read";

/// As it follows "while".
std::string work_in(const AppState& state) {
  if (state.loading) return k_reading;
  if (state.exporting) return "wrote files of";
  if (state.revisions.awaited) return "compared the revisions of";
  if (state.sweep.running) return "swept directions of";
  if (!state.model) return "";
  if (state.mold.running || state.mold.line_awaited || state.mold.solids_awaited) return "made the mold of";
  if (state.actions.running || state.actions.changes_awaited) return "sought side actions of";
  return state.figures.measuring ? "measured the regions of" : "";
}

constexpr std::array k_fields = {&WindowRecord::part,        &WindowRecord::compare,
                                 &WindowRecord::work,        &WindowRecord::part_at_work,
                                 &WindowRecord::former_work, &WindowRecord::former_part};

}  // namespace

WindowRecord record_of(const AppState& state) {
  WindowRecord record{.part = state.path, .compare = state.revisions.path, .work = work_in(state)};
  if (!record.work.empty()) record.part_at_work = state.loading ? state.loading->path : state.path;
  return record;
}

std::string record_text(const WindowRecord& record) {
  // No name of a file has the letter that parts them.
  std::string text;
  for (const auto field : k_fields) (text += record.*field) += '\0';
  return text;
}

WindowRecord parse_record(std::string_view text) {
  WindowRecord record;
  for (const auto field : k_fields) {
    const std::size_t end = text.find('\0');
    if (end == std::string_view::npos) break;
    record.*field = text.substr(0, end);
    text.remove_prefix(end + 1);
  }
  return record;
}

Resumed resume(const WindowRecord& crashed, const std::string& cause) {
  const std::string name = one_line(std::filesystem::path(crashed.part_at_work).filename().string());
  Resumed next{
      .said = fmt::format("The window crashed ({}){}. Settings and bookmarks are kept.", cause,
                          crashed.work.empty() ? "" : fmt::format(" while it {} {}", crashed.work, name))};
  next.opened.former_work = crashed.work;
  next.opened.former_part = crashed.part_at_work;
  const bool twice = !crashed.work.empty() && crashed.work == crashed.former_work &&
                     crashed.part_at_work == crashed.former_part;
  if (twice || crashed.work == k_reading) {
    next.said += fmt::format(" {} is not opened again by itself.", name);
  } else {
    next.opened.part = crashed.part;
    next.opened.compare = crashed.compare;
  }
  return next;
}

}  // namespace moldlight::gui
