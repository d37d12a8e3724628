// The work on one part of a batch: its file is what was planned, its process, its result, what lies beside
// it.
#pragma once

#include <cstdint>
#include <string>

#include "batch/child_process.hpp"
#include "batch/manifest.hpp"
#include "batch/store.hpp"

namespace moldlight::batch {

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
