// All results of a batch in one file: a table, a database, a page for a browser. Each is replaced whole or
// not at all.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "batch/part_result.hpp"
#include "classify/json.hpp"

namespace moldlight::batch {

struct MergeFiles {
  std::string csv, sqlite, html;  // empty: not wanted
};

/// A column of table and database: its name, its type in SQLite, and what it has of a part, null where that
/// is not known.
struct ResultColumn {
  std::string name, type;
  std::function<Json(const PartResult&)> of;
};
[[nodiscard]] const std::vector<ResultColumn>& result_columns();

/// What takes the rows one by one; without finish() nothing is left behind.
class MergeSink {
 public:
  MergeSink() = default;
  MergeSink(const MergeSink&) = delete;
  MergeSink& operator=(const MergeSink&) = delete;
  virtual ~MergeSink() = default;
  virtual void add(const PartResult& result) = 0;
  virtual void finish() = 0;
};

/// Text is as shown_text() has it; where a path is not so, `path_bytes` has it as it is. Tables `batch` and
/// `parts`, `previous` with the parts of the last merge of another plan into this file, and the views worst,
/// changed, more_than_two_actions and failed. Throws FileError for a file that is there and no such database.
[[nodiscard]] std::unique_ptr<MergeSink> sqlite_sink(const std::string& path, const Manifest& manifest);

/// `first` takes the rows, too, if it is given, and finishes before any file is put in place. Throws
/// FileError, Cancelled, what `first` throws; files that were wanted are then as they were.
ReadingCounts merge(const Manifest& manifest, const MergeFiles& files, const Progress& progress,
                    MergeSink* first = nullptr);

}  // namespace moldlight::batch
