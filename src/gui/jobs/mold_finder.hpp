// Keeps the parting line up with the settings, and the mold's halves where they are looked at: once the split
// mesh of a direction is there, they are found on threads of their own.
#pragma once

#include <functional>
#include <memory>

#include "base/job.hpp"
#include "gui/app_state.hpp"
#include "study/study.hpp"

namespace moldlight::gui {

class MoldFinder {
 public:
  /// `wake` is called from the finder's threads when there is something new.
  explicit MoldFinder(const std::function<void()>& wake)
      : line_job_({.wake = wake, .wake_for_progress = true}),
        solids_job_({.wake = wake, .wake_for_progress = true}),
        inserts_job_({.wake = wake}) {}

  /// A hand at settings: lines follow it one after the other, halves wait. `solids`: the halves are looked
  /// at.
  struct Wants {
    bool moving = false, solids = false;
  };
  /// Call it every frame, after the figures were updated.
  void update(const AppState& state, MoldState& mold, const Wants& wants);
  /// Gives up what runs.
  void cancel();

 private:
  /// All that a line depends on.
  struct LineInputs {
    std::shared_ptr<const PartModel> model;
    Asked<moldlight::MoldLine>::Inputs asked;
    double required_draft_deg = 0.0;
    bool operator==(const LineInputs&) const = default;
  };
  struct SolidInputs {
    std::shared_ptr<const MoldLine> line;
    Asked<MoldHalves>::Inputs asked;
    bool operator==(const SolidInputs&) const = default;
  };
  void update_line(const AppState& state, MoldState& mold, bool moving);
  void update_solids(const AppState& state, MoldState& mold, const Wants& wants);
  void update_inserts(const AppState& state, MoldState& mold);

  Job<MoldLine> line_job_;
  Job<MoldSolids> solids_job_;
  Job<std::vector<InsertActions>> inserts_job_;
  std::optional<LineInputs> line_of_;  // for which the job runs or has ended
  std::optional<SolidInputs> solids_of_;
  std::shared_ptr<const SplitMesh> found_for_;
  std::shared_ptr<const MoldSolids> inserts_of_;
  std::shared_ptr<const ActionPlan> inserts_by_;
};

}  // namespace moldlight::gui
