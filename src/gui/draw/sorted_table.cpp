#include "gui/draw/sorted_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace moldlight::gui {

// Layout units.
constexpr float k_filter_width = 220.0F, k_heading_row = 24.0F, k_cell_gap = 8.0F, k_bar_room = 12.0F;

void SortedTable::draw_filter(const Ui& ui, BottomHeader& header, const char* list, const TextSpec& spec) {
  TextSpec field = spec;
  field.width = ui.px(k_filter_width);
  header.place(field.width);
  text_field(ui, "##filter", filter_, field);
  Keyboard& keyboard = ui.memory->keyboard;
  const ImGuiID rows_id = ImGui::GetID(list);
  if (ImGui::IsItemActive() && !keyboard.focused(rows_id) && keyboard.takes(ControlKey::down))
    keyboard.give_to(rows_id);
}

void SortedTable::forget() {
  filter_.fill(0);
  cursor = {};
  asked_.clear();
}

bool SortedTable::draw_headings(const Ui& ui, std::vector<SortedColumn> columns, float left) {
  columns_ = std::move(columns);
  const glm::vec2 start = cursor_at();
  const float width = room_left() - ui.px(k_bar_room), height = ui.px(k_heading_row);
  float others = ui.px(left), shares = 0.0F;
  for (const SortedColumn& each : columns_) {
    others += ui.px(each.width);
    if (each.width <= 0.0F) shares += each.share;
  }
  ends_ = {ui.px(left)};
  for (const SortedColumn& each : columns_)
    ends_.push_back(ends_.back() + (each.width > 0.0F ? ui.px(each.width)
                                                      : std::floor((width - others) * each.share / shares)));
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const SortedColumn& column = columns_[k];
    const bool chosen = by_ == column.name;
    put_cursor({start.x + begin_of(k), start.y});
    const glm::vec2 size(ends_[k + 1] - ends_[k], height);
    bool hovered = false;
    if (column.sorts) {
      const Pressable heading = pressable(ui, ("sort by " + column.name).c_str(), size);
      hovered = heading.hovered;
      if (heading.clicked) descending_ = chosen ? !descending_ : column.most_first;
      if (heading.clicked) by_ = column.name;
    } else {
      ImGui::Dummy(size);
    }
    if (!column.help.empty()) tooltip(ui, {}, column.help);
    const std::string mark = chosen ? (descending_ ? " ↓" : " ↑") : "";
    draw_cell(ui, {start, start + glm::vec2(width, height)}, k,
              {ui.fonts.small, hovered || chosen ? ui.colours->text : ui.colours->muted}, column.name + mark);
  }
  put_cursor({start.x, start.y + height});
  ImGui::Dummy(ImVec2(width, 0.0F));
  std::string asked = fmt::format("{}\n{}\n{}", by_, descending_, filter_.data());
  return std::exchange(asked_, asked) != asked;
}

float SortedTable::end_of(const Ui& ui, std::size_t column) const {
  const bool words = !columns_[column].figure;
  return ends_[column + 1] - (words ? ui.px(k_cell_gap) : 0.0F);
}

void SortedTable::draw_cell(const Ui& ui, const ScreenBox& row, std::size_t column,
                            const Lettering& lettering, std::string_view text, float mark) const {
  const float top = row.centre().y - 0.5F * lettering.font.size, end = row.min.x + end_of(ui, column);
  if (columns_[column].figure) return draw_text_to(lettering, end, top, text);
  const float from = row.min.x + begin_of(column) + ui.px(mark);
  draw_text(lettering, {from, top}, fitted(lettering.font, text, end - from));
}

}  // namespace moldlight::gui
