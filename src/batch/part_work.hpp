// The work on one part of a batch: its file is what was planned, its process, its result, what lies beside
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "batch/manifest.hpp"
#include "batch/store.hpp"
#include "classify/json.hpp"

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

/// How the work on a part came out. Unreachable: the file cannot be read from here, although it could be when
/// it was planned, which says nothing of the part. Ended: somebody ended its process each time.
enum class WorkEnd : std::uint8_t { done, failed, unreachable, ended };

struct WorkOutcome {
  WorkEnd end = WorkEnd::done;
  std::string reason;  // of a part that is not done
  Json result;         // of a part that is done or failed: what is put under its key
};

struct WorkSettings {
  ChildLimits limits;
  int retries = 1;
};

/// Throws Cancelled, and Error where no process can be started.
[[nodiscard]] WorkOutcome work_on(const Manifest& manifest, const Row& row, const std::string& file,
                                  const WorkSettings& settings, const Progress& progress);

/// Makes the picture of a part along the direction of its report, or the page of the whole work, in a process
/// of its own. Returns why not, or nothing. Throws Cancelled.
[[nodiscard]] std::string make_beside(const Manifest& manifest, const Row& row, const std::string& file,
                                      const Json& report, Beside what, const std::string& made,
                                      const ChildLimits& limits, const Progress& progress);

}  // namespace moldlight::batch
