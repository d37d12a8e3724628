// A batch's rows with their results, as the window's table shows them.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "batch/result_table.hpp"
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

/// A part of the batch as it is opened: its file, and the settings that its result was made with.
struct BatchPart {
  std::string path;
  ReadOptions reading;
  PartNotes notes;
};
[[nodiscard]] BatchPart batch_part(const BatchTable& table, std::size_t row);

}  // namespace moldlight::gui
