// A program of ours that runs beside and hands back bytes; killed when it is no longer wanted.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "base/progress.hpp"

namespace moldlight {

struct ChildResult {
  std::string bytes;  // what it wrote to the descriptor
  int exit_code = 0;  // -1 where a signal ended it
  int signal = 0;     // that ended it; 0 for none
  bool timed_out = false;
};

struct ChildCommand {
  std::string program;  // path
  std::vector<std::string> arguments;
  int result_descriptor = 3;
  std::chrono::seconds time_limit{60};
};

/// Runs the program with its standard streams closed off, until it ends, `time_limit` is over or `progress`
/// is cancelled (throws Cancelled). None where it cannot be started.
[[nodiscard]] std::optional<ChildResult> run_child(const ChildCommand& command, const Progress& progress);

}  // namespace moldlight
