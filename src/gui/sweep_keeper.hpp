// Runs the window's sweep: one at a time, in the background, given up when the part goes.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <utility>

#include "gui/app_state.hpp"
#include "gui/jobs/sweep_job.hpp"

namespace moldlight::gui {

class SweepKeeper {
 public:
  SweepKeeper(Measurer::MakeContext make_context, std::function<void()> wake)
      : make_context_(std::move(make_context)), wake_(std::move(wake)) {}

  /// Starts the sweep that the choices ask for, of the part that is shown, with its method. What an earlier
  /// one found goes.
  void start(const AppState& state, SweepState& sweep, double now_s);
  /// Ends the sweep early; its result is what is done.
  void cancel();
  /// Call it every frame.
  void update(const AppState& state, SweepState& sweep, double now_s);
  /// The last sweep's result, once, for pictures of what it found.
  [[nodiscard]] std::shared_ptr<const SweepResult> take_result() { return std::exchange(pictured_, nullptr); }
  /// When update() wants to be called next without any input; infinity for not at all.
  [[nodiscard]] double wake_s() const { return wake_s_; }

 private:
  void drop();
  void take_directions(SweepState& sweep);
  void tell_progress(SweepState& sweep, double now_s);
  void finish(SweepState& sweep);

  const Measurer::MakeContext make_context_;
  const std::function<void()> wake_;
  std::shared_ptr<const PartModel> model_;
  std::unique_ptr<SweepJob> job_;
  std::list<std::unique_ptr<SweepJob>> given_up_;  // until their threads have ended
  std::vector<EvaluatedDirection> waiting_;        // to be put on the map
  std::size_t put_ = 0;                            // of them
  std::shared_ptr<const SweepResult> pictured_;    // the result whose pictures were not taken yet
  MethodSettings method_;                          // of the sweep
  std::size_t scored_ = 0;
  double started_s_ = 0.0, scoring_s_ = 0.0, wake_s_ = 0.0;
};

}  // namespace moldlight::gui
