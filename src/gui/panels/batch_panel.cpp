#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"

namespace moldlight::gui {

using batch::RowColumn;

// Layout units.
constexpr float k_batch_row = 42.0F, k_thumbnail_width = 60.0F, k_unit_width = 40.0F, k_figure_width = 88.0F,
                k_batch_filter = 220.0F, k_least_texts = 380.0F;
constexpr float k_batch_share = 0.24F, k_batch_alone = 0.6F;  // of the window's height, beside a part or none

VerdictLight light_of(const batch::PartResult& row) {
  const auto state = std::ranges::find(k_verdict_states, row.verdict);
  return state == k_verdict_states.end()
             ? VerdictLight::gray
             : light_of(static_cast<VerdictState>(state - k_verdict_states.begin()));
}

void BatchPanel::draw(const PanelContext& context, const BatchPicture& picture) {
  const auto& table = context.state.batch;
  const bool opens = context.state.dialogs.batch && !open_;
  open_ = context.state.dialogs.batch && table;
  if (!open_) return;
  const Ui& ui = context.ui;
  bool& shown = context.edits.dialogs.batch;
  bool changed = table_ != table;
  if (changed) {
    table_ = table;
    order_ = {};
    filter_.fill(0);
    cursor_ = {};
  }
  if (opens) context.layout.fold_bottom("Batch", false);
  if (context.layout.begin_bottom(ui, "Batch")) {
    BottomHeader header(ui, "Batch");
    if (header.button({"close batch", Icon::close, "Close; L opens it again"})) shown = false;
    header.place(ui.px(k_batch_filter));
    text_field(ui, "##filter", filter_,
               {.hint = "part, verdict or reason", .width = ui.px(k_batch_filter), .starts = opens});
    // From the words straight into the list.
    Keyboard& keyboard = ui.memory->keyboard;
    const ImGuiID rows = ImGui::GetID("batch rows");
    if (ImGui::IsItemActive() && !keyboard.focused(rows) && keyboard.takes(ControlKey::down))
      keyboard.give_to(rows);
    const auto& counts = table->counts;
    header.end(fmt::format("{}: {} done, {} failed, {} missing", table->manifest.command, counts.done,
                           counts.failed, counts.missing),
               ui.colours->muted);
    changed = changed || order_.filter != filter_.data();
    order_.filter = filter_.data();
    choose_columns(ui);
    const batch::RowOrder before = order_;
    draw_headings(context);
    changed = changed || before.column != order_.column || before.descending != order_.descending;
    if (changed) rows_ = batch::ordered_rows(table->rows, order_);
    if (rows_.empty()) hint(ui, "No part matches these words.");
    const RowList list{.id = "batch rows",
                       .count = rows_.size(),
                       .row_height = k_batch_row,
                       .share = context.state.model ? k_batch_share : k_batch_alone};
    const auto at = cursor_.row();
    draw_list(ui, list, cursor_, [&](std::size_t k) { draw_row(context, k, picture); });
    // The arrow keys go from part to part.
    if (cursor_.row() && cursor_.row() != at && *cursor_.row() < rows_.size())
      context.edits.ask(&Commands::open_batch_part, rows_[*cursor_.row()]);
  } else {
    shown = false;  // another one was unfolded
  }
  context.layout.end();
}

/// Those for which there is room beside the part and its verdict; what it takes to mold it comes first.
void BatchPanel::choose_columns(const Ui& ui) {
  constexpr std::array<RowColumn, 3> k_given_up = {RowColumn::undercuts, RowColumn::share,
                                                   RowColumn::undercut};
  columns_ = batch::used_columns(table_->rows);
  float room = room_left() - ui.px(k_thumbnail_width + k_least_texts);
  for (const RowColumn each : columns_)
    if (each > RowColumn::verdict) room -= ui.px(each == RowColumn::unit ? k_unit_width : k_figure_width);
  for (const RowColumn each : k_given_up)
    if (room < 0.0F && std::erase(columns_, each) > 0) room += ui.px(k_figure_width);
}

/// Right end of a column from the row's left end; the part and its verdict share what the others leave.
float BatchPanel::right_of(const Ui& ui, std::size_t column, float width) const {
  float others = ui.px(k_thumbnail_width);
  for (const RowColumn each : columns_)
    if (each > RowColumn::verdict) others += ui.px(each == RowColumn::unit ? k_unit_width : k_figure_width);
  float right = ui.px(k_thumbnail_width);
  for (std::size_t k = 0; k <= column; ++k) {
    const RowColumn each = columns_[k];
    right += each == RowColumn::part      ? std::floor(0.4F * (width - others))
             : each == RowColumn::verdict ? std::floor(0.6F * (width - others))
             : each == RowColumn::unit    ? ui.px(k_unit_width)
                                          : ui.px(k_figure_width);
  }
  return right;
}

void BatchPanel::draw_headings(const PanelContext& context) {
  const Ui& ui = context.ui;
  const glm::vec2 start = cursor_at();
  const float width = room_left() - ui.px(12), height = ui.px(k_row_height);
  float left = ui.px(k_thumbnail_width);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const RowColumn column = columns_[k];
    const float right = right_of(ui, k, width);
    put_cursor({start.x + left, start.y});
    const std::string name(batch::column_name(column));
    const Pressable heading = pressable(ui, ("by " + name).c_str(), {right - left, height});
    if (heading.clicked) {
      order_.descending = order_.column == column ? !order_.descending : !is_text(column);
      order_.column = column;
    }
    const bool chosen = order_.column == column;
    const std::string text = name + (chosen ? (order_.descending ? " ↓" : " ↑") : "");
    const float inset = is_text(column) ? 0.0F : right - left - text_size(ui.fonts.small, text).x;
    draw_text({ui.fonts.small, heading.hovered || chosen ? ui.colours->text : ui.colours->muted},
              {start.x + left + inset, start.y + 0.5F * (height - ui.fonts.small.size)}, text);
    left = right;
  }
  put_cursor({start.x, start.y + height});
  ImGui::Dummy(ImVec2(width, 0.0F));
}

void BatchPanel::draw_row(const PanelContext& context, std::size_t index, const BatchPicture& picture) {
  const Ui& ui = context.ui;
  const batch::PartResult& row = table_->rows[rows_[index]];
  const std::string id = fmt::format("row {}", row.row);
  const BatchPart part = batch_part(*table_, rows_[index]);
  const Row line = list_row(ui, {.id = id.c_str(),
                                 .height = k_batch_row,
                                 .chosen = part.path == context.state.path,
                                 .marked = cursor_.is_at(index)});
  tooltip(ui, row.path,
          row.settings + (row.sentence.empty() ? "" : "\n" + row.sentence) +
              (row.reason.empty() ? "" : "\n" + row.reason));
  ImDrawList& list = window_list();
  const glm::vec2 at = line.box.min + glm::vec2(ui.px(4), ui.px(2));
  if (row.picture) draw_picture(list, picture(row.key), {at, at + glm::vec2(ui.px(50), ui.px(38))}, ui.px(4));
  const float width = ImGui::GetWindowWidth() - ui.px(12), middle = line.box.centre().y;
  const bool failed = row.state == batch::ResultState::failed, done = row.state == batch::ResultState::done;
  float left = ui.px(k_thumbnail_width);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const RowColumn column = columns_[k];
    const float right = right_of(ui, k, width);
    const bool verdict = column == RowColumn::verdict;
    // Why a part failed stands where its figures would be.
    const float light = verdict ? ui.px(14) : 0.0F,
                room = (failed && verdict ? width : right - ui.px(8)) - left - light;
    if (verdict)
      list.AddCircleFilled({line.box.min.x + left + ui.px(4), middle}, ui.px(4), light_colour(light_of(row)));
    const std::string text = fitted(ui.fonts.body, batch::cell_text(row, column), room);
    const float inset = is_text(column) ? light : right - left - text_size(ui.fonts.body, text).x;
    draw_text(list,
              {ui.fonts.body, failed && verdict ? ui.colours->warning
                              : done            ? ui.colours->text
                                                : ui.colours->muted},
              {line.box.min.x + left + inset, middle - 0.5F * ui.fonts.body.size}, text);
    if (failed && verdict) break;
    left = right;
  }
  put_cursor({line.box.min.x, line.box.max.y});
  if (line.clicked) context.edits.ask(&Commands::open_batch_part, rows_[index]);
}

}  // namespace moldlight::gui
