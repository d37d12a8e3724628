// Keeps the side actions up with the settings: once the split mesh of a direction is there, they are looked
// for on a thread of their own, and after them what to change to do without.
#pragma once

#include <functional>
#include <memory>

#include "base/job.hpp"
#include "gui/app_state.hpp"
#include "study/study.hpp"

namespace moldlight::gui {

class ActionFinder {
 public:
  /// `wake` is called from the finder's thread when there is something new.
  explicit ActionFinder(const std::function<void()>& wake)
      : job_({.wake = wake, .wake_for_progress = true}), changes_({.wake = wake}) {}

  /// Call it every frame, after the figures were updated. `moving`: a hand is at settings, whose actions are
  /// not wanted yet.
  void update(const AppState& state, ActionsState& actions, bool moving);
  /// Gives up what runs.
  void cancel() {
    job_.give_up();
    changes_.give_up();
  }

 private:
  /// All that a plan depends on.
  struct Inputs {
    std::shared_ptr<const PartModel> model;
    Asked<ActionPlan>::Inputs asked;
    bool operator==(const Inputs&) const = default;
  };
  struct Found {
    Study study;  // that knows the plan
    ActionBodies bodies;
  };
  static Found find(Study study, const Progress& progress);
  void take_plan(const Figures& figures, ActionsState& actions);
  void take_changes(ActionsState& actions);

  Job<Found> job_;
  Job<std::shared_ptr<const Changes>> changes_;
  std::optional<Inputs> asked_;  // for which the job runs or has ended
  std::shared_ptr<const SplitMesh> planned_;
};

}  // namespace moldlight::gui
