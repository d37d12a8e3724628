// The clock of a sweep: when it has to stop, and what it shows meanwhile.
#pragma once

#include <atomic>
#include <chrono>
#include <string_view>

#include "base/progress.hpp"

namespace moldlight {

class SweepClock {
 public:
  /// `time_limit_s` of 0 means none. The clock starts here.
  SweepClock(const Progress& progress, double time_limit_s)
      : progress_(progress), time_limit_s_(time_limit_s) {}
  /// For a part of a sweep that has a limit of its own; over when the whole is, too, which must outlive it.
  SweepClock(const SweepClock& whole, double time_limit_s)
      : progress_(whole.progress_), time_limit_s_(time_limit_s), whole_(&whole) {}

  [[nodiscard]] double elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// Cancelled, or over the time. Asked by whoever still has work to do, from any thread.
  [[nodiscard]] bool stopped() const {
    const bool over = time_limit_s_ > 0.0 && elapsed_s() > time_limit_s_;
    if (over) cut_short_ = true;
    return cancelled() || over || (whole_ && whole_->stopped());
  }
  [[nodiscard]] bool cancelled() const {
    if (progress_.cancelled()) cut_short_ = true;
    if (whole_) (void)whole_->cancelled();
    return progress_.cancelled();
  }
  /// For work that is given up when the sweep is cancelled, but not at the time limit.
  [[nodiscard]] Progress until_cancelled() const { return Progress(&progress_); }
  /// Work was left undone.
  [[nodiscard]] bool cut_short() const { return cut_short_; }
  /// Reports without throwing when cancelled: a sweep ends by itself and keeps what it has.
  void report(std::string_view stage, double fraction) const {
    if (!progress_.cancelled()) progress_.report(stage, fraction);
  }

 private:
  const Progress& progress_;
  double time_limit_s_;
  const SweepClock* whole_ = nullptr;
  mutable std::atomic<bool> cut_short_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace moldlight
