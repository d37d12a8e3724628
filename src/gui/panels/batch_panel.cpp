#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"

namespace moldlight::gui {

constexpr float k_part_row = 28.0F, k_row_with_picture = 54.0F, k_thumbnail_width = 68.0F;  // layout units
constexpr float k_state_width = 74.0F, k_figure_width = 104.0F;

void BatchPanel::draw(const PanelContext& context, const BatchPicture& picture) {
  const auto& table = context.state.batch;
  const bool opens = context.state.dialogs.batch && !open_;
  open_ = context.state.dialogs.batch && table;
  if (!open_) return;
  const Ui& ui = context.ui;
  bool changed = table_ != table;
  if (changed) {
    table_ = table;
    columns_ = used_columns(*table);
    pictures_ = std::ranges::any_of(table->rows, &batch::PartResult::picture);
    order_ = {};
    filter_.fill(0);
    selected_ = -1;
  }
  if (begin_dialog(ui, "Batch", {ui.px(980), ui.px(640)})) {
    changed = text_field(ui, "##filter", filter_,
                         {.hint = "part, settings, state or reason", .width = ui.px(280), .starts = opens}) ||
              changed;
    ImGui::SameLine();
    const auto& counts = table->counts;
    row_text(ui, ui.note(), room_left(),
             fmt::format("{}: {} done, {} failed, {} missing", table->manifest.command, counts.done,
                         counts.failed, counts.missing));
    if (order_.filter != filter_.data()) {
      order_.filter = filter_.data();
      changed = true;
    }
    const BatchOrder before = order_;
    draw_headings(context);
    changed = changed || before.column != order_.column || before.descending != order_.descending;
    if (changed) rows_ = ordered_rows(*table, order_);
    draw_rows(context, picture);
    if (button(ui, "Close", {.width = ui.px(96)})) context.edits.dialogs.batch = false;
  }
  if (end_dialog(ui)) context.edits.dialogs.batch = false;
}

/// Right end of a column from the row's left end; the first takes what the others leave. Figures have half of
/// the width, since the reasons of failures stand there, too.
float BatchPanel::right_of(const Ui& ui, std::size_t column, float width) const {
  const auto figures = static_cast<float>(std::max<std::size_t>(columns_.size(), 3) - 2);
  const float figure = std::max(ui.px(k_figure_width), std::floor(0.5F * width / figures));
  float right = width;
  for (std::size_t k = columns_.size(); k-- > column + 1;)
    right -= columns_[k] == BatchColumn::state ? ui.px(k_state_width) : figure;
  return right;
}

void BatchPanel::draw_headings(const PanelContext& context) {
  const Ui& ui = context.ui;
  const glm::vec2 start = cursor_at();
  const float width = room_left() - ui.px(12), height = ui.px(k_row_height);
  float left = pictures_ ? ui.px(k_thumbnail_width) : 0.0F;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const BatchColumn column = columns_[k];
    const float right = right_of(ui, k, width);
    put_cursor({start.x + left, start.y});
    const std::string name(batch_column_name(column));
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

void BatchPanel::draw_rows(const PanelContext& context, const BatchPicture& picture) {
  const Ui& ui = context.ui;
  const float row_height = ui.px(pictures_ ? k_row_with_picture : k_part_row);
  ImGui::BeginChild("rows", ImVec2(0, -ui.px(k_row_height + 8)));
  const int count = static_cast<int>(rows_.size());
  if (count == 0) hint(ui, "No part matches these words.");
  Keyboard& keyboard = ui.memory->keyboard;
  const int page = std::max(1, static_cast<int>(ImGui::GetWindowHeight() / row_height) - 1);
  if (const int steps = keyboard.takes_steps(page, count); steps != 0 && count > 0) {
    selected_ = std::clamp(selected_ + steps, 0, count - 1);
    ImGui::SetScrollY((static_cast<float>(selected_) + 0.5F) * row_height - 0.5F * ImGui::GetWindowHeight());
  }
  selected_ = std::min(selected_, count - 1);
  if (selected_ >= 0 && keyboard.takes(ControlKey::press)) {
    context.edits.ask(&Commands::open_batch_part, rows_[static_cast<std::size_t>(selected_)]);
    context.edits.dialogs.batch = false;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  ImGuiListClipper clipper;
  clipper.Begin(count, row_height);
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      ImGui::PushID(k);
      draw_row(context, static_cast<std::size_t>(k), picture);
      ImGui::PopID();
    }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

void BatchPanel::draw_row(const PanelContext& context, std::size_t index, const BatchPicture& picture) {
  const Ui& ui = context.ui;
  const batch::PartResult& row = table_->rows[rows_[index]];
  const float width = room_left(), height = ui.px(pictures_ ? k_row_with_picture : k_part_row);
  const Pressable line = pressable(ui, fmt::format("row {}", row.row).c_str(), {width, height});
  ImDrawList& list = window_list();
  const glm::vec2 min = line.box.min, max = line.box.max;
  if (line.hovered || static_cast<int>(index) == selected_)
    fill(list, {min, max}, ui.colours->field_hovered, ui.px(4));
  if (row.picture) {
    const glm::vec2 at = min + glm::vec2(0.0F, ui.px(3));
    draw_picture(list, picture(row.key), {at, at + glm::vec2(ui.px(64), ui.px(48))}, ui.px(4));
  }
  const float inner = ImGui::GetWindowContentRegionMax().x - ui.px(12);
  float left = pictures_ ? ui.px(k_thumbnail_width) : 0.0F;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const BatchColumn column = columns_[k];
    const float right = right_of(ui, k, std::min(width, inner));
    // Why a part failed stands where its figures would be.
    const bool is_reason = k == 2 && row.state == batch::ResultState::failed;
    std::string text = is_reason ? row.reason : batch_cell(row, column);
    const float room = is_reason ? std::min(width, inner) - left : right - left - ui.px(8);
    text = fitted(ui.fonts.body, text, room);
    const ImU32 colour = row.state == batch::ResultState::done ? ui.colours->text
                         : is_reason                           ? ui.colours->warning
                                                               : ui.colours->muted;
    const float inset = is_text(column) || is_reason ? 0.0F : right - left - text_size(ui.fonts.body, text).x;
    draw_text(list, {ui.fonts.body, colour},
              {min.x + left + inset, 0.5F * (min.y + max.y - ui.fonts.body.size)}, text);
    if (is_reason) break;
    left = right;
  }
  tooltip(ui, row.path, row.settings + (row.reason.empty() ? "" : "\n" + row.reason));
  if (line.clicked) {
    context.edits.ask(&Commands::open_batch_part, rows_[index]);
    context.edits.dialogs.batch = false;
  }
}

}  // namespace moldlight::gui
