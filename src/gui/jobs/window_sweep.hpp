// Runs the window's sweep: one at a time, in the background, given up when the part goes.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "base/job.hpp"
#include "gui/app_state.hpp"

namespace moldlight::gui {

class WindowSweep {
 public:
  explicit WindowSweep(std::function<void()> wake) : job_({.wake = std::move(wake)}) {}

  /// Starts the sweep that the choices ask for, of the part that is shown, with its method and what is
  /// allowed of side actions. What an earlier one found goes. One that nobody asked for ranks as a mold maker
  /// does, whatever the choices, and what is known already stays until it has more.
  void start(const AppState& state, SweepState& sweep, double now_s, bool by_itself = false);
  /// Ends the sweep; of what it found by then its result alone stays, where it has one.
  void give_up(SweepState& sweep);
  /// Ends the sweep early; its result is what is done.
  void cancel() { job_.cancel(); }
  /// Call it every frame.
  void update(const AppState& state, SweepState& sweep, double now_s);
  /// The last sweep's result, once, for pictures of what it found.
  [[nodiscard]] std::shared_ptr<const SweepResult> take_result() { return std::exchange(pictured_, nullptr); }
  /// When update() wants to be called next without any input; infinity for not at all.
  [[nodiscard]] double wake_s() const { return wake_s_; }

 private:
  void drop();
  /// Puts some of what was scored on the map; true where there is more.
  bool take_scored(SweepState& sweep);
  void note_progress(const JobStatus& status, SweepState& sweep, double now_s);

  /// Directions scored and not yet seen by the window, in the order in which their scores came.
  struct Scored {
    std::mutex mutex;
    std::deque<EvaluatedDirection> directions;
    std::shared_ptr<const SweepResult> named;  // see SweepListener
  };
  std::shared_ptr<const PartModel> model_;
  Job<std::shared_ptr<const SweepResult>> job_;
  std::shared_ptr<Scored> scored_by_job_ = std::make_shared<Scored>();
  std::shared_ptr<const SweepResult> pictured_;  // the result whose pictures were not taken yet
  SweepSettings settings_;                       // of the sweep
  double started_s_ = 0.0, wake_s_ = 0.0;
};

}  // namespace moldlight::gui
