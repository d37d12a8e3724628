// A batch's rows with their results, as the window's table shows them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "batch/part_result.hpp"
#include "gui/store/part_notes.hpp"
#include "io/read_options.hpp"

namespace moldlight::gui {

struct BatchTable {
  batch::Manifest manifest;
  std::vector<batch::PartResult> rows;
  batch::ReadingCounts counts;
};

/// Of a batch's folder, or the batch.json in it; throws FileError, Cancelled.
[[nodiscard]] BatchTable load_batch_table(const std::string& path, const Progress& progress);

/// What the table is sorted by.
enum class BatchColumn : std::uint8_t {
  part,
  state,
  undercut,
  share,
  undercuts,
  side_actions,
  unreleased,
  pieces
};
/// Else of figures.
[[nodiscard]] inline bool is_text(BatchColumn column) {
  return column == BatchColumn::part || column == BatchColumn::state;
}
[[nodiscard]] std::string_view batch_column_name(BatchColumn column);
/// As the table shows it; empty where the row has none.
[[nodiscard]] std::string batch_cell(const batch::PartResult& row, BatchColumn column);
/// Columns that any row has something in.
[[nodiscard]] std::vector<BatchColumn> used_columns(const BatchTable& table);

struct BatchOrder {
  std::string filter = {};  // words that all stand in path, settings, state or reason
  BatchColumn column = BatchColumn::share;
  bool descending = true;
};
/// Numbers of the rows that pass, in order; those that have nothing in the column come last.
[[nodiscard]] std::vector<std::size_t> ordered_rows(const BatchTable& table, const BatchOrder& order);

/// A part of the batch as it is opened: its file, and the settings that its result was made with.
struct BatchPart {
  std::string path;
  ReadOptions reading;
  PartNotes notes;
};
[[nodiscard]] BatchPart batch_part(const BatchTable& table, std::size_t row);

}  // namespace moldlight::gui
