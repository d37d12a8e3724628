// Common parts of panels along the bottom: the line at their top, and lists of which mouse and keyboard
// choose a row.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "gui/draw/widgets.hpp"

namespace moldlight::gui {

/// The line at a panel's top: its name on the left, items one after the other from the right, and a text in
/// what is left between them.
class BottomHeader {
 public:
  BottomHeader(const Ui& ui, const char* name);
  /// Puts the cursor where an item of this width in pixels goes.
  void place(float width);
  bool button(const IconButtonSpec& spec) {
    place(ui_.px(k_row_height));
    return icon_button(ui_, spec);
  }
  /// A bar from 0 to 1, `width` in layout units.
  void progress(double share, float width);
  /// Draws the text and ends the line. `tip`: shown when the mouse is on the text, where it is not empty.
  void end(std::string_view text, ImU32 colour, std::string_view tip = {});

 private:
  [[nodiscard]] float middle() const { return start_.y + 0.5F * ui_.px(k_row_height); }

  const Ui& ui_;
  glm::vec2 start_;
  float width_, left_, right_;  // of what is free, pixels
};

/// A column of a list: where it ends (figures) or begins (words), from the row's left, layout units.
struct ListColumn {
  std::string_view heading, help;
  float at;
  bool figure;
};
void draw_headings(const Ui& ui, std::span<const ListColumn> columns);
/// A cell's text in the middle of a row; words are shortened to `room` pixels, 0: not.
void draw_cell(const Ui& ui, const ScreenBox& row, const ListColumn& column, const Lettering& lettering,
               std::string_view text, float room = 0.0F);

/// Below the cells of a row that has two lines: what else there is to say, from `left` on, layout units, up
/// to `beside` from the right end.
void draw_second_line(const Ui& ui, const ScreenBox& row, float left, std::string_view text,
                      float beside = 6.0F);

/// The row of a list that the keyboard has marked.
class RowCursor {
 public:
  [[nodiscard]] bool is_at(std::size_t row) const { return row_ == row; }
  [[nodiscard]] const std::optional<std::size_t>& row() const { return row_; }
  /// Inside of the list, before its rows: brings the marked one to the middle, if it has moved. Pixels.
  void scroll(float row_height, float list_height);
  /// After the list, which is the item just drawn: moves as the keyboard asks, where the list has it; `page`
  /// in rows. The row that is pressed.
  std::optional<std::size_t> follow(const Ui& ui, std::string_view id, std::size_t page, std::size_t count);

 private:
  std::optional<std::size_t> row_;
  bool moved_ = false;
};

/// A list, at most `share` of the window's height high, and in the window where its panel is not scrolled.
struct RowList {
  const char* id;
  std::size_t count;
  float row_height;  // layout units
  float share;
};
/// Draws the rows that are in sight. The row that the keyboard has pressed.
std::optional<std::size_t> draw_list(const Ui& ui, const RowList& list, RowCursor& cursor,
                                     const std::function<void(std::size_t)>& draw_row);

/// A row's item and its background.
struct RowSpec {
  const char* id;
  float height;         // layout units
  float beside = 0.0F;  // layout units at its right end that are another control's
  bool chosen = false, marked = false;
};
struct Row {
  ScreenBox box;
  bool clicked = false, hovered = false;  // by the mouse, also on what is beside
};
Row list_row(const Ui& ui, const RowSpec& spec);

}  // namespace moldlight::gui
