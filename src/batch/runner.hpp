// Running a batch, or a shard of it, on this machine: a process a part, several at a time.
#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <string>

#include "base/progress.hpp"
#include "batch/manifest.hpp"
#include "classify/option.hpp"

namespace moldlight::batch {

/// How a run goes about it; nothing here changes a result.
struct RunSettings {
  int processes = 0;         // at a time, 0: one a core, [0, 4096]
  double part_time_s = 600;  // by the clock, 0: none
  int part_memory_mb = 0;    // resident, 0: none
  int retries = 1;           // of a part that failed by other than a limit
  bool retry_failed = false;
  bool thumbnails = false;
  bool reports = false;
  bool live = false;  // reports are live; of commands that have such
};
[[nodiscard]] std::span<const Option<RunSettings>> run_options();

/// What has become of the rows so far; from any thread.
struct RunCounts {
  std::atomic<std::size_t> rows = 0;       // of the shard, without those that share another's result
  std::atomic<std::size_t> before = 0;     // of those, what had a result when the run began
  std::atomic<std::size_t> done = 0;       // by this run
  std::atomic<std::size_t> failed = 0;     // by this run, for good
  std::atomic<std::size_t> elsewhere = 0;  // by another run meanwhile
};

/// What a run shows while it goes on, from any of its threads, one call at a time.
struct RunListener {
  std::function<void(const std::string& path, const std::string& reason)> failed = {};
  /// Of a result for the best direction, which is no axis.
  std::function<void(const std::string& path, const std::string& sentence)> off_axis = {};
  std::function<void(const std::string& sentence)> warning = {};
};

struct RunEnd {
  bool interrupted = false;
  std::size_t undone = 0;  // rows that have no result after all
  /// Why the run ended early or left parts undone, where trying again may help; empty: it did not.
  std::string try_again;
};

/// A part whose result is there is passed over, and so is a failure unless `retry_failed`. Everything that
/// was done stays done, whenever and however the run ends. Any number of runs may work on one batch at once:
/// they begin at different places, and a part that two of them have in hand at the same moment gets one
/// result. `parts` is the folder that the paths begin in.
class Run {
 public:
  Run(const Manifest& manifest, const RunSettings& settings, Shard shard, std::string parts);

  [[nodiscard]] const RunCounts& counts() const { return counts_; }
  [[nodiscard]] RunEnd carry_out(const RunListener& listener, const Progress& progress);

 private:
  const Manifest& manifest_;
  RunSettings settings_;
  Shard shard_;
  std::string parts_;
  RunCounts counts_;
};

}  // namespace moldlight::batch
