// The work of a batch from the command line: any subcommand that can be one, with its own flags, which are
// checked as if it were run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "batch/plan.hpp"
#include "cli/command.hpp"

namespace moldlight::cli {

/// "classify, sweep, actions, mold or pieces": the commands that can be the work.
[[nodiscard]] std::string work_names();
/// Throws UsageError for any other.
[[nodiscard]] const CommandRow& work_row(std::string_view command);

/// Reads the settings that all rows have and makes those of single rows of them. Throws UsageError for a
/// subcommand that can be no work, for what it refuses, and for flags that name files: all parts would write
/// to the same.
class BatchWork {
 public:
  BatchWork(std::string command, const std::vector<std::string>& flags);

  [[nodiscard]] batch::RowSettings settings(const std::vector<batch::NamedValue>& row) const;

 private:
  std::string command_;
  std::vector<batch::NamedValue> common_;
};

}  // namespace moldlight::cli
