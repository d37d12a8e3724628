#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"

namespace moldlight::gui {

using batch::RowColumn;

namespace {

// Layout units.
constexpr float k_batch_row = 42.0F, k_thumbnail_width = 60.0F, k_unit_width = 40.0F, k_figure_width = 88.0F,
                k_least_texts = 460.0F;
constexpr float k_batch_share = 0.24F, k_batch_alone = 0.6F;  // of the window's height, beside a part or none

/// Those for which there is room beside the part and its verdict; what it takes to mold it comes first.
std::vector<RowColumn> chosen_columns(const Ui& ui, const BatchTable& table) {
  constexpr std::array<RowColumn, 3> k_given_up = {RowColumn::undercuts, RowColumn::share,
                                                   RowColumn::undercut};
  std::vector<RowColumn> columns = batch::used_columns(table.rows);
  float room = room_left() - ui.px(k_thumbnail_width + k_least_texts);
  for (const RowColumn each : columns)
    if (each > RowColumn::verdict) room -= ui.px(each == RowColumn::unit ? k_unit_width : k_figure_width);
  for (const RowColumn each : k_given_up)
    if (room < 0.0F && std::erase(columns, each) > 0) room += ui.px(k_figure_width);
  return columns;
}

SortedColumn sorted_column(RowColumn column) {
  SortedColumn sorted{.name = std::string(batch::column_name(column)),
                      .figure = !is_text(column),
                      .most_first = !is_text(column)};
  if (column > RowColumn::verdict) sorted.width = column == RowColumn::unit ? k_unit_width : k_figure_width;
  sorted.share = column == RowColumn::part ? 0.4F : 0.6F;
  return sorted;
}

}  // namespace

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
  if (std::exchange(of_, table) != table) {
    table_ = SortedTable(std::string(batch::column_name(RowColumn::share)), true);
    table_.forget();
  }
  if (opens) context.layout.fold_bottom("Batch", false);
  if (context.layout.begin_bottom(ui, "Batch", 0.0F, k_wide_table)) {
    BottomHeader header(ui, "Batch");
    if (header.button({"close batch", Icon::close, "Close; L opens it again"})) shown = false;
    table_.draw_filter(ui, header, "batch rows", {.hint = "part, verdict or reason", .starts = opens});
    const auto& counts = table->counts;
    header.end(fmt::format("{}: {} done, {} failed, {} missing", table->manifest.command, counts.done,
                           counts.failed, counts.missing),
               ui.colours->muted);
    columns_ = chosen_columns(ui, *table);
    std::vector<SortedColumn> headings;
    for (const RowColumn each : columns_) headings.push_back(sorted_column(each));
    if (table_.draw_headings(ui, std::move(headings), k_thumbnail_width)) {
      batch::RowOrder order{.filter = table_.filter(), .descending = table_.descending()};
      for (const RowColumn each : columns_)
        if (batch::column_name(each) == table_.by()) order.column = each;
      table_.rows = batch::ordered_rows(table->rows, order);
    }
    if (table_.rows.empty()) hint(ui, "No part matches these words.");
    const RowList list{.id = "batch rows",
                       .count = table_.rows.size(),
                       .row_height = k_batch_row,
                       .share = context.state.model ? k_batch_share : k_batch_alone};
    const auto at = table_.cursor.row();
    draw_list(ui, list, table_.cursor, [&](std::size_t k) { draw_row(context, k, picture); });
    // The arrow keys go from part to part.
    const auto now = table_.cursor.row();
    if (now && now != at && *now < table_.rows.size())
      context.edits.ask(&Commands::open_batch_part, table_.rows[*now]);
  } else {
    shown = false;  // another one was unfolded
  }
  context.layout.end();
}

void BatchPanel::draw_row(const PanelContext& context, std::size_t index, const BatchPicture& picture) {
  constexpr float k_light = 14.0F, k_line = 17.0F;
  const Ui& ui = context.ui;
  const batch::PartResult& row = of_->rows[table_.rows[index]];
  const std::string id = fmt::format("row {}", row.row);
  const BatchPart part = batch_part(*of_, table_.rows[index]);
  const Row line = list_row(ui, {.id = id.c_str(),
                                 .height = k_batch_row,
                                 .chosen = part.path == context.state.path,
                                 .marked = table_.cursor.is_at(index)});
  tooltip(ui, row.path,
          row.settings + (row.sentence.empty() ? "" : "\n" + row.sentence) +
              (row.reason.empty() ? "" : "\n" + row.reason));
  ImDrawList& list = window_list();
  const glm::vec2 at = line.box.min + glm::vec2(ui.px(4), ui.px(2));
  if (row.picture) draw_picture(list, picture(row.key), {at, at + glm::vec2(ui.px(50), ui.px(38))}, ui.px(4));
  const bool failed = row.state == batch::ResultState::failed, done = row.state == batch::ResultState::done;
  const ImU32 colour = failed ? ui.colours->warning : done ? ui.colours->text : ui.colours->muted;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const std::string text = batch::cell_text(row, columns_[k]);
    if (columns_[k] != RowColumn::verdict) {
      table_.draw_cell(ui, line.box, k, {ui.fonts.body, done ? ui.colours->text : ui.colours->muted}, text);
      continue;
    }
    const float left = line.box.min.x + table_.begin_of(k), from = left + ui.px(k_light);
    list.AddCircleFilled({left + ui.px(4), line.box.centre().y}, ui.px(4), light_colour(light_of(row)));
    // Why a part failed stands where its figures would be.
    const float end = failed ? line.box.max.x - ui.px(12) : line.box.min.x + table_.end_of(ui, k);
    const std::vector<std::string> lines = lines_within(ui.fonts.body, text, end - from, 2);
    float top = line.box.centre().y - 0.5F * ui.px(k_line) * static_cast<float>(lines.size());
    for (const std::string& each : lines) {
      draw_text(list, {ui.fonts.body, colour}, {from, top}, each);
      top += ui.px(k_line);
    }
    if (failed) break;
  }
  put_cursor({line.box.min.x, line.box.max.y});
  if (line.clicked) context.edits.ask(&Commands::open_batch_part, table_.rows[index]);
}

}  // namespace moldlight::gui
