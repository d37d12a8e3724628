// How far a sweep is: share done, directions, rate, time left.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace moldlight::cli {

class SweepMeter {
 public:
  /// Counts a scored direction; from any thread.
  void count() { ++scored_; }

  /// One line; with a bar where there are columns for it. One call at a time.
  [[nodiscard]] std::string text(std::string_view stage, double fraction, int columns);

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<std::size_t> scored_ = 0;
  Clock::time_point start_ = Clock::now();
  double done_ = 0.0;  // share, never less than before
};

}  // namespace moldlight::cli
