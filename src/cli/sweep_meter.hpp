// How far a sweep is: share done, directions, rate, time left.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "session/sweep/sweep_settings.hpp"

namespace moldlight::cli {

class SweepMeter {
 public:
  explicit SweepMeter(const SweepSettings& settings);

  /// Counts a scored direction; from any thread.
  void count() { ++scored_; }

  /// One line; with a bar where there are columns for it. One call at a time.
  [[nodiscard]] std::string text(std::string_view stage, double fraction, int columns);

 private:
  using Clock = std::chrono::steady_clock;
  struct Stage {
    std::string_view name;
    double cost = 0.0;  // milliseconds as expected; what counts is the ratio to the others
  };

  /// Share of the whole sweep that is done, in [0, 1], never less than before.
  double share_done(std::string_view stage, double fraction);

  std::array<Stage, 5> stages_;
  std::atomic<std::size_t> scored_ = 0;
  Clock::time_point start_ = Clock::now();
  double done_ = 0.0;
};

}  // namespace moldlight::cli
