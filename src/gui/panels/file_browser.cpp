// The dialog that opens a part.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "batch/manifest.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"
#include "io/part_formats.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

std::string size_text(std::uintmax_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (bytes < 1000000) return fmt::format("{:.0f} kB", value / 1e3);
  return bytes < 1000000000 ? fmt::format("{:.1f} MB", value / 1e6) : fmt::format("{:.1f} GB", value / 1e9);
}

/// Draws a line of the list, clicked or not.
bool list_line(const Ui& ui, int index, const FileBrowser::Line& line, bool selected) {
  ImGui::PushID(index);
  const bool clicked = ImGui::InvisibleButton("line", ImVec2(room_left(), ui.px(k_row_height)));
  ImGui::PopID();
  const ScreenBox box = item_box();
  const auto& [min, max] = box;
  if (!ImGui::IsItemVisible()) return clicked;
  ImDrawList& list = window_list();
  if (ImGui::IsItemHovered() || selected) list.AddRectFilled(min, max, ui.colours->field_hovered, ui.px(6));
  if (selected) list.AddRect(min, max, ui.colours->accent, ui.px(6), 0, 1.5F * ui.scale);
  const float middle = 0.5F * (min.y + max.y);
  draw_icon(list, line.folder ? Icon::folder : Icon::file, {min.x + ui.px(14), middle}, ui.px(13),
            ui.colours->muted);
  const std::string note = fitted(ui.fonts.small, line.note, ui.px(260));
  const float note_width = text_size(ui.fonts.small, note).x;
  draw_text(list, ui.text(), {min.x + ui.px(30), middle - 0.5F * ui.fonts.body.size},
            fitted(ui.fonts.body, line.path.filename().string(), max.x - min.x - ui.px(50) - note_width));
  draw_text_to(ui.note(), max.x - ui.px(10), middle - 0.5F * ui.fonts.small.size, note);
  ui.memory->controls["file " + line.path.filename().string()] = box;
  return clicked;
}

}  // namespace

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  folder_ = fs::weakly_canonical(folder, error);
  if (error) folder_ = folder;
  filter_.fill(0);
  scan(folder_);
}

void FileBrowser::scan(const fs::path& folder) {
  std::error_code error;
  scanned_ = folder;
  entries_.clear();
  problem_.clear();
  selected_ = -1;
  fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  if (error) problem_ = fmt::format("This folder cannot be read: {}.", error.message());
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    Entry found{.name = entry->path().filename().string(), .folder = entry->is_directory(ignored)};
    if (found.name.starts_with('.')) continue;
    if (!found.folder) found.bytes = entry->file_size(ignored);
    entries_.push_back(std::move(found));
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower_letters(a.name) < lower_letters(b.name);
  });
}

FileBrowser::Sought FileBrowser::sought() const {
  const std::string typed(filter_.data());
  const std::size_t slash = typed.rfind('/');
  if (slash == std::string::npos) return {folder_, typed};
  const char* const home = std::getenv("HOME");
  const bool at_home = typed.starts_with("~/") && home != nullptr;
  const fs::path folder = at_home ? fs::path(home) / typed.substr(2, std::max<std::size_t>(slash, 2) - 2)
                                  : fs::path(typed.substr(0, slash + 1));
  return {folder_ / folder, typed.substr(slash + 1)};  // what begins at the root stays
}

int FileBrowser::entered(const std::vector<Line>& shown) const {
  if (selected_ >= 0) return selected_ < static_cast<int>(shown.size()) ? selected_ : -1;
  // Without a selection, what is typed may name a line, or leave one alone.
  const std::string name = sought().name;
  const auto named = std::ranges::find_if(
      shown, [&](const Line& line) { return !name.empty() && line.path.filename() == name; });
  if (named != shown.end()) return static_cast<int>(named - shown.begin());
  return shown.size() == 1 ? 0 : -1;
}

void FileBrowser::draw_head(const PanelContext& context) {
  const Ui& ui = context.ui;
  heading(ui, context.state.dialogs.browser_compares ? "Compare with the new revision" : "Open a part");
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  if (icon_button(ui, {"up", Icon::up, "The folder above (Backspace)"})) next_ = folder_.parent_path();
  ImGui::SameLine();
  const float room = room_left();
  row_text(ui, ui.muted(), room, fitted(ui.fonts.body, folder_.string(), room));
  if (filter_[0] == 0 && ui.memory->keyboard.takes(ControlKey::erase)) next_ = folder_.parent_path();
  const TextSpec filter{.hint = "filter by name, or a path",
                        .width = room_left() - ui.px(110),
                        .starts = std::exchange(starts_, false)};
  if (text_field(ui, "##filter", filter_, filter)) {
    selected_ = -1;
    if (const fs::path folder = sought().folder; folder != scanned_) scan(folder);
  }
  if (chip(ui, "all files", all_files_, false)) all_files_ = !all_files_;
}

std::vector<FileBrowser::Line> FileBrowser::lines(const AppState& state) const {
  std::vector<Line> lines;
  constexpr std::size_t k_most_recent = 5;
  if (filter_[0] == 0) {
    for (std::size_t k = 0; k < std::min(state.recent.size(), k_most_recent); ++k) {
      const fs::path path = state.recent[k];
      lines.push_back({.path = path, .note = path.parent_path().string(), .folder = false, .recent = true});
    }
  }
  const std::string name = sought().name, filter = lower_letters(name);
  for (const Entry& entry : entries_) {
    if (!entry.folder && !all_files_ && entry.name != name && !is_part_file_name(entry.name)) continue;
    if (lower_letters(entry.name).find(filter) == std::string::npos) continue;
    lines.push_back({.path = scanned_ / entry.name,
                     .note = entry.folder ? std::string() : size_text(entry.bytes),
                     .folder = entry.folder,
                     .recent = false});
  }
  return lines;
}

bool FileBrowser::draw_list(const PanelContext& context) {
  const Ui& ui = context.ui;
  ImGui::BeginChild("files", ImVec2(0, -ui.px(k_row_height + 8)));
  if (!problem_.empty()) hint(ui, problem_);
  const std::vector<Line> shown = lines(context.state);
  const int count = static_cast<int>(shown.size());
  Keyboard& keyboard = ui.memory->keyboard;
  const int page = std::max(1, static_cast<int>(ImGui::GetWindowHeight() / ui.px(k_row_height)) - 1);
  const int steps = keyboard.takes_steps(page, count);
  if (steps != 0 && count > 0) selected_ = std::clamp(selected_ + steps, 0, count - 1);
  std::optional<Line> chosen;
  if (problem_.empty() && shown.empty() && filter_[0] != 0)
    hint(ui, fmt::format("No part in {} has such a name.", scanned_.string()));
  const int taken = entered(shown);
  if (taken >= 0 && (keyboard.takes(ControlKey::press) || std::exchange(opens_, false)))
    chosen = shown[static_cast<std::size_t>(taken)];
  opens_ = false;
  if (taken < 0 && filter_[0] != 0 && keyboard.takes(ControlKey::press)) starts_ = true;  // to be mended
  for (int k = 0; k < count; ++k) {
    const Line& line = shown[static_cast<std::size_t>(k)];
    const bool first = k == 0 || shown[static_cast<std::size_t>(k - 1)].recent != line.recent;
    if (first && shown.front().recent) hint(ui, line.recent ? "RECENT" : "THIS FOLDER");
    if (list_line(ui, k, line, k == selected_)) chosen = line;
    if (k == selected_ && steps != 0) ImGui::SetScrollHereY(0.5F);
  }
  ImGui::EndChild();
  const bool compares = context.state.dialogs.browser_compares;
  const bool enters = chosen && chosen->folder && (compares || !batch::is_batch(chosen->path.string()));
  if (enters) {
    next_ = chosen->path;
  } else if (chosen) {
    context.edits.ask(compares ? &Commands::compare_with : &Commands::open_part, chosen->path.string());
    context.edits.dialogs.browser = false;
  }
  if (next_) {
    enter(*std::exchange(next_, std::nullopt));
    starts_ = true;
  }
  return taken >= 0;
}

void FileBrowser::draw(const PanelContext& context) {
  if (!context.state.dialogs.browser) {
    open_ = false;
    return;
  }
  if (!open_) {
    open_ = starts_ = true;
    fs::path start = context.state.path.empty() ? fs::path() : fs::path(context.state.path).parent_path();
    if (start.empty() && !context.state.recent.empty())
      start = fs::path(context.state.recent.front()).parent_path();
    std::error_code ignored;
    enter(start.empty() || !fs::is_directory(start, ignored) ? fs::current_path(ignored) : start);
  }
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Open", {ui.px(640), ui.px(520)})) {
    draw_head(context);
    const bool can_open = draw_list(context);
    if (button(ui, "Cancel", {.width = ui.px(96)})) context.edits.dialogs.browser = false;
    if (can_open) {
      ImGui::SameLine();
      opens_ = button(ui, "Open", {.width = ui.px(96), .strong = true});
    }
  }
  if (end_dialog(ui)) context.edits.dialogs.browser = false;
}

}  // namespace moldlight::gui
