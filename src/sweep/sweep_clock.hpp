// The clock of a sweep: when it has to stop, and what it shows meanwhile; its stages, in their order.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <string_view>

#include "base/progress.hpp"

namespace moldlight {

namespace sweep_stage {
inline constexpr std::string_view k_candidates = "finding candidates";
inline constexpr std::string_view k_scoring = "scoring";
inline constexpr std::string_view k_refining = "refining";
inline constexpr std::string_view k_measuring = "measuring the best";
inline constexpr std::string_view k_polishing = "polishing";
inline constexpr std::string_view k_proving = "proving";  // its fraction is what is decided
inline constexpr std::string_view k_actions = "finding side actions";
inline constexpr std::string_view k_final = "tilting the best";
}  // namespace sweep_stage

/// Share of a whole sweep's time that is over, [0, 1], by what the stages usually take. Side actions, where
/// they are sought, take more than all the rest.
[[nodiscard]] inline double sweep_share_done(std::string_view stage, double fraction, bool with_actions) {
  struct Stage {
    std::string_view name;
    double share;
  };
  constexpr double k_of_actions = 0.6;
  constexpr std::array<Stage, 8> k_stages = {{{sweep_stage::k_candidates, 0.02},
                                              {sweep_stage::k_scoring, 0.25},
                                              {sweep_stage::k_refining, 0.15},
                                              {sweep_stage::k_measuring, 0.18},
                                              {sweep_stage::k_polishing, 0.15},
                                              {sweep_stage::k_proving, 0.05},
                                              {sweep_stage::k_actions, 0.0},
                                              {sweep_stage::k_final, 0.2}}};
  double before = 0.0;
  for (const Stage& s : k_stages) {
    double share = with_actions ? (1.0 - k_of_actions) * s.share : s.share;
    if (with_actions && s.name == sweep_stage::k_actions) share = k_of_actions;
    if (s.name == stage) return before + share * std::clamp(fraction, 0.0, 1.0);
    before += share;
  }
  return 0.0;
}

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
