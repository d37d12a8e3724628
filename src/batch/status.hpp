// How far a batch is, and the reasons of the parts that failed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "batch/manifest.hpp"

namespace moldlight::batch {

struct BatchStatus {
  std::size_t rows = 0, done = 0, failed = 0, missing = 0;
  std::size_t shared = 0;  // rows among them that share the result of another
  /// Reasons of failures with how many rows have each, the most frequent first.
  std::vector<std::pair<std::string, std::size_t>> reasons;
  std::vector<std::pair<std::size_t, std::string>> missing_rows;  // number and path, where asked for
  std::vector<std::string> refused;                               // as ReadingCounts has it
};

struct StatusOptions {
  Shard shard = {};
  bool reasons = true, missing_rows = false;
};

[[nodiscard]] BatchStatus batch_status(const Manifest& manifest, const StatusOptions& options,
                                       const Progress& progress);

/// For reading; ends with a line end.
[[nodiscard]] std::string status_text(const Manifest& manifest, const BatchStatus& status);
/// Schema moldlight.batch.status/1.
[[nodiscard]] Json status_json(const Manifest& manifest, const BatchStatus& status);

}  // namespace moldlight::batch
