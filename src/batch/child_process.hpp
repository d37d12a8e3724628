// One part's process: what it writes, how it ends, and the limits that end it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"

namespace moldlight::batch {

struct ChildLimits {
  double time_s = 0.0;           // by the clock; 0: none
  std::size_t memory_bytes = 0;  // resident, with its own children; 0: none
  int threads = 1;               // that it may compute with
};

enum class ChildEnd : std::uint8_t { exited, signalled, out_of_time, out_of_memory, cancelled };

struct ChildResult {
  ChildEnd end = ChildEnd::exited;
  int code = 0;  // exit code, or the signal that ended it
  std::string out, err;
};

/// Runs this program with the arguments to its end. It dies with the thread that calls; its own children die
/// with it where a limit or a cancelled progress ends it. Resident memory is looked at every 20 ms: a limit
/// of address space would count what the ray and task libraries reserve and never touch. Throws Error where
/// no process can be started.
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                                    const Progress& progress);

}  // namespace moldlight::batch
