// The dialog that opens a part.
#include <algorithm>
#include <cctype>
#include <cstdlib>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"
#include "io/part_formats.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string size_text(std::uintmax_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (bytes < 1000000) return fmt::format("{:.0f} kB", value / 1e3);
  return bytes < 1000000000 ? fmt::format("{:.1f} MB", value / 1e6) : fmt::format("{:.1f} GB", value / 1e9);
}

struct ListLine {
  Icon icon;
  std::string_view name, note;
};

/// Draws a line of the list, clicked or not.
bool list_line(const Ui& ui, const char* id, const ListLine& line) {
  const bool clicked =
      ImGui::InvisibleButton(id, ImVec2(ImGui::GetContentRegionAvail().x, ui.px(k_row_height)));
  if (!ImGui::IsItemVisible()) return clicked;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled(min, max, ui.colours->field_hovered, ui.px(6));
  const float middle = 0.5F * (min.y + max.y);
  draw_icon(list, line.icon, {min.x + ui.px(14), middle}, ui.px(13), ui.colours->muted);
  const float note_width = text_size(ui.fonts.small, line.note).x;
  draw_text(list, {ui.fonts.body, ui.colours->text}, {min.x + ui.px(30), middle - 0.5F * ui.fonts.body.size},
            fitted(ui.fonts.body, line.name, max.x - min.x - ui.px(50) - note_width));
  draw_text_to({ui.fonts.small, ui.colours->muted}, max.x - ui.px(10), middle - 0.5F * ui.fonts.small.size,
               line.note);
  return clicked;
}

}  // namespace

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  folder_ = fs::weakly_canonical(folder, error);
  if (error) folder_ = folder;
  entries_.clear();
  filter_.fill(0);
  problem_.clear();
  fs::directory_iterator entry(folder_, fs::directory_options::skip_permission_denied, error);
  if (error) problem_ = fmt::format("This folder cannot be read: {}.", error.message());
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    Entry found{.name = entry->path().filename().string(), .folder = entry->is_directory(ignored)};
    if (found.name.starts_with('.')) continue;
    if (!found.folder) found.bytes = entry->file_size(ignored);
    entries_.push_back(std::move(found));
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
}

void FileBrowser::draw_head(const PanelContext& context) {
  const Ui& ui = context.ui;
  heading(ui, "Open a part");
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  if (icon_button(ui, {"up", Icon::up, "The folder above"})) enter(folder_.parent_path());
  ImGui::SameLine();
  const float room = ImGui::GetContentRegionAvail().x;
  row_text(ui, {ui.fonts.body, ui.colours->muted}, room, fitted(ui.fonts.body, folder_.string(), room));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui.px(110));
  ImGui::InputTextWithHint("##filter", "filter by name", filter_.data(), filter_.size());
  if (chip(ui, "all files", all_files_, false)) all_files_ = !all_files_;
}

void FileBrowser::draw_list(const PanelContext& context) {
  const Ui& ui = context.ui;
  ImGui::BeginChild("files", ImVec2(0, -ui.px(k_row_height + 8)));
  if (!problem_.empty()) hint(ui, problem_);
  if (filter_[0] == 0 && !context.state.recent.empty()) {
    hint(ui, "RECENT");
    for (std::size_t k = 0; k < std::min<std::size_t>(context.state.recent.size(), 5); ++k) {
      const fs::path path = context.state.recent[k];
      if (list_line(ui, fmt::format("recent {}", k).c_str(),
                    {Icon::file, path.filename().string(),
                     fitted(ui.fonts.small, path.parent_path().string(), ui.px(260))})) {
        context.edits.ask(&Commands::open_part, path.string());
        context.edits.dialogs.browser = false;
      }
    }
    hint(ui, "THIS FOLDER");
  }
  const std::string filter = lower(filter_.data());
  std::optional<fs::path> next;
  for (const Entry& entry : entries_) {
    if (!entry.folder && !all_files_ && !is_part_file_name(entry.name)) continue;
    if (!filter.empty() && lower(entry.name).find(filter) == std::string::npos) continue;
    if (!list_line(ui, entry.name.c_str(),
                   {entry.folder ? Icon::folder : Icon::file, entry.name,
                    entry.folder ? std::string() : size_text(entry.bytes)})) {
      continue;
    }
    if (entry.folder) {
      next = folder_ / entry.name;
    } else {
      context.edits.ask(&Commands::open_part, (folder_ / entry.name).string());
      context.edits.dialogs.browser = false;
    }
  }
  ImGui::EndChild();
  if (next) enter(*next);
}

void FileBrowser::draw(const PanelContext& context) {
  if (!context.state.dialogs.browser) {
    open_ = false;
    return;
  }
  if (!open_) {
    open_ = true;
    fs::path start = context.state.path.empty() ? fs::path() : fs::path(context.state.path).parent_path();
    if (start.empty() && !context.state.recent.empty())
      start = fs::path(context.state.recent.front()).parent_path();
    std::error_code ignored;
    enter(start.empty() || !fs::is_directory(start, ignored) ? fs::current_path(ignored) : start);
  }
  const Ui& ui = context.ui;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (begin_dialog(
          ui, "Open",
          {std::min(ui.px(640), window.x - ui.px(32)), std::min(ui.px(520), window.y - ui.px(32))})) {
    draw_head(context);
    draw_list(context);
    if (button(ui, "Cancel", {.width = ui.px(96)})) context.edits.dialogs.browser = false;
  }
  end_dialog();
}

}  // namespace moldlight::gui
