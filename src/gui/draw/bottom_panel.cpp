#include "gui/draw/bottom_panel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moldlight::gui {

constexpr float k_item_gap = 4.0F, k_bar_gap = 6.0F;  // between items, layout units
constexpr float k_heading_height = 20.0F;             // layout units
constexpr float k_fewest_rows = 2.0F, k_list_margin = 24.0F;

BottomHeader::BottomHeader(const Ui& ui, const char* name)
    : ui_(ui),
      start_(cursor_at()),
      width_(room_left()),
      left_(start_.x + text_size(ui.fonts.strong, name).x + ui.px(12)),
      right_(start_.x + width_) {
  draw_text(ui.strong(), {start_.x, middle() - 0.5F * ui.fonts.strong.size}, name);
}

void BottomHeader::place(float width) {
  right_ -= width;
  put_cursor({right_, start_.y});
  right_ -= ui_.px(k_item_gap);
}

void BottomHeader::progress(double share, float width) {
  right_ -= ui_.px(k_bar_gap);
  place(ui_.px(width));
  put_cursor({ImGui::GetCursorScreenPos().x, middle() - ui_.px(2)});
  progress_bar(ui_, share, ui_.px(width));
}

void BottomHeader::end(std::string_view text, ImU32 colour, std::string_view tip) {
  const float room = right_ - left_ - ui_.px(8);
  if (!tip.empty()) {
    put_cursor({left_, start_.y});
    ImGui::Dummy(ImVec2(std::max(room, 1.0F), ui_.px(k_row_height)));
    tooltip(ui_, {}, tip);
  }
  draw_text({ui_.fonts.body, colour}, {left_, middle() - 0.5F * ui_.fonts.body.size},
            fitted(ui_.fonts.body, text, room));
  put_cursor({start_.x, start_.y + ui_.px(k_row_height)});
  ImGui::Dummy(ImVec2(width_, 0.0F));
}

void draw_headings(const Ui& ui, std::span<const ListColumn> columns) {
  const glm::vec2 corner = cursor_at();
  for (const ListColumn& column : columns) {
    const float x = corner.x + ui.px(column.at), size = text_size(ui.fonts.small, column.heading).x;
    const glm::vec2 at(column.figure ? x - size : x, corner.y + ui.px(3));
    draw_text(ui.note(), at, column.heading);
    if (column.help.empty()) continue;
    put_cursor(at);
    ImGui::Dummy(ImVec2(size, ui.fonts.small.size));
    tooltip(ui, {}, column.help);
  }
  put_cursor({corner.x, corner.y + ui.px(k_heading_height)});
}

void draw_cell(const Ui& ui, const ScreenBox& row, const ListColumn& column, const Lettering& lettering,
               std::string_view text, float room) {
  const float x = row.min.x + ui.px(column.at), y = row.centre().y - 0.5F * lettering.font.size;
  if (column.figure) {
    draw_text_to(lettering, x, y, text);
  } else {
    draw_text(lettering, {x, y}, room > 0.0F ? fitted(lettering.font, text, room) : std::string(text));
  }
}

void draw_second_line(const Ui& ui, const ScreenBox& row, float left, std::string_view text, float beside) {
  const float x = row.min.x + ui.px(left);
  draw_text(ui.note(), {x, row.max.y - ui.px(6) - ui.fonts.small.size},
            fitted(ui.fonts.small, text, row.max.x - ui.px(beside) - x));
}

void RowCursor::scroll(float row_height, float list_height) {
  if (row_ && std::exchange(moved_, false))
    ImGui::SetScrollY((static_cast<float>(*row_) + 0.5F) * row_height - 0.5F * list_height);
}

std::optional<std::size_t> RowCursor::follow(const Ui& ui, std::string_view id, std::size_t page,
                                             std::size_t count) {
  const ScreenBox box = item_box();
  ui.memory->controls[std::string(id)] = box;
  if (!has_keyboard(ui, id, box)) {
    row_.reset();
    return std::nullopt;
  }
  Keyboard& keyboard = ui.memory->keyboard;
  const int all = static_cast<int>(count), steps = keyboard.takes_steps(static_cast<int>(page), all);
  moved_ = steps != 0 || !row_;
  row_ = static_cast<std::size_t>(std::clamp(static_cast<int>(row_.value_or(0)) + steps, 0, all - 1));
  return keyboard.takes(ControlKey::press) ? row_ : std::nullopt;
}

std::optional<std::size_t> draw_list(const Ui& ui, const RowList& list, RowCursor& cursor,
                                     const std::function<void(std::size_t)>& draw_row) {
  if (list.count == 0) return std::nullopt;
  const float below = screen_size().y - cursor_at().y - ImGui::GetScrollY() - ui.px(k_list_margin);
  const float row = ui.px(list.row_height), room = std::min(list.share * screen_size().y, below);
  const float fits = std::max(std::floor(room / row), k_fewest_rows);
  const float height = std::min(fits, static_cast<float>(list.count)) * row;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  ImGui::BeginChild(list.id, ImVec2(room_left(), height), false,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings);
  cursor.scroll(row, height);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(list.count), row);
  while (clipper.Step())
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) draw_row(static_cast<std::size_t>(k));
  ImGui::EndChild();
  const auto pressed = cursor.follow(ui, list.id, static_cast<std::size_t>(fits), list.count);
  ImGui::PopStyleVar();
  return pressed;
}

Row list_row(const Ui& ui, const RowSpec& spec) {
  const glm::vec2 start = cursor_at();
  const float width = room_left(), height = ui.px(spec.height);
  Row row{.box = {start, start + glm::vec2(width, height)}};
  row.clicked = ImGui::InvisibleButton(spec.id, ImVec2(width - ui.px(spec.beside), height));
  ui.memory->controls[spec.id] = item_box();
  row.hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                ImGui::IsMouseHoveringRect(row.box.min, row.box.max);
  ImDrawList& list = window_list();
  if (spec.chosen || ImGui::IsItemHovered())
    fill(list, row.box, spec.chosen ? ui.colours->field_active : ui.colours->field, ui.px(6));
  if (spec.marked) list.AddRect(row.box.min, row.box.max, ui.colours->accent, ui.px(6), 0, 1.5F * ui.scale);
  return row;
}

}  // namespace moldlight::gui
