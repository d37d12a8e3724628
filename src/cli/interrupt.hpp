// Ctrl-C and a polite kill end the work at its next report of progress, so that nothing is left half done.
#pragma once

#include "base/progress.hpp"

namespace moldlight::cli {

/// While it lives, SIGINT and SIGTERM cancel the progress; a second signal ends the program at once. One at a
/// time.
class InterruptGuard {
 public:
  explicit InterruptGuard(Progress& progress);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

}  // namespace moldlight::cli
