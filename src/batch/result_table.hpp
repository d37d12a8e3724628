// The results of a batch as a table for who looks through them: columns, cells, order.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "batch/part_result.hpp"

namespace moldlight::batch {

/// What the table is sorted by.
enum class RowColumn : std::uint8_t {
  part,
  verdict,
  unit,
  undercut,
  share,
  undercuts,
  side_actions,
  unreleased,
  pieces
};
/// Else of figures.
[[nodiscard]] inline bool is_text(RowColumn column) { return column <= RowColumn::unit; }
[[nodiscard]] std::string_view column_name(RowColumn column);
/// As the table shows it; empty where the row has none. What has no verdict has what became of it.
[[nodiscard]] std::string cell_text(const PartResult& row, RowColumn column);
/// Columns that any row has something in.
[[nodiscard]] std::vector<RowColumn> used_columns(std::span<const PartResult> rows);

struct RowOrder {
  std::string filter = {};  // words that all stand in path, settings, state, verdict or reason
  RowColumn column = RowColumn::share;
  bool descending = true;
};
/// Numbers of the rows that pass, in order; those that have nothing in the column come last.
[[nodiscard]] std::vector<std::size_t> ordered_rows(std::span<const PartResult> rows, const RowOrder& order);

}  // namespace moldlight::batch
