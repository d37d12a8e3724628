// A table along the bottom: a click on a heading sorts it, words filter it, keys go through its rows.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/draw/bottom_panel.hpp"

namespace moldlight::gui {

struct SortedColumn {
  std::string name;  // the heading; it is the control "sort by <name>"
  std::string_view help = {};
  bool figure = true;      // set to the right
  bool most_first = true;  // by the first click
  float width = 0.0F;      // layout units; 0: its share of what the others leave
  float share = 1.0F;      // of all that have one
  bool sorts = true;
};

class SortedTable {
 public:
  SortedTable(std::string by, bool descending) : by_(std::move(by)), descending_(descending) {}

  /// Into the header: the field whose words filter the rows. From there the arrow keys lead into the list of
  /// that name. `starts`: it takes what is typed from now on.
  void draw_filter(const Ui& ui, BottomHeader& header, const char* list, const TextSpec& spec);
  [[nodiscard]] std::string filter() const { return filter_.data(); }
  /// Empty, with the keyboard on no row.
  void forget();

  /// The headings, from `left` in a row on, layout units; true where order or filter have changed since the
  /// last call.
  bool draw_headings(const Ui& ui, std::vector<SortedColumn> columns, float left = 0.0F);
  /// The name of the column that it is sorted by.
  [[nodiscard]] const std::string& by() const { return by_; }
  [[nodiscard]] bool descending() const { return descending_; }

  /// A text of the row, shortened where it is words; `mark` are left free before these, layout units.
  void draw_cell(const Ui& ui, const ScreenBox& row, std::size_t column, const Lettering& lettering,
                 std::string_view text, float mark = 0.0F) const;
  /// From the row's left, pixels: where a column begins, and where its text ends.
  [[nodiscard]] float begin_of(std::size_t column) const { return ends_[column]; }
  [[nodiscard]] float end_of(const Ui& ui, std::size_t column) const;

  std::vector<std::size_t> rows;  // what each is of, in order
  RowCursor cursor;               // its row is a place among them

 private:
  std::string by_;
  bool descending_;
  std::array<char, 128> filter_{};
  std::vector<SortedColumn> columns_;
  std::vector<float> ends_;  // of the columns' room, from that of what is left of the first on, pixels
  std::string asked_;        // filter and order of the last call
};

}  // namespace moldlight::gui
