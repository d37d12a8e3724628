// Keeps what the study says of the window's part up with the settings: once the split mesh of a direction is
// there, side actions and the parting line are looked for on threads of their own, the mold's halves where
// they are looked at; then the verdict, and the cards of recommended directions beside it.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "base/job.hpp"
#include "gui/app_state.hpp"
#include "study/study.hpp"

namespace moldlight::gui {

/// The part with the present questions, side actions among them, and no answers.
[[nodiscard]] Study asked_study(const AppState& state);
/// The same with the regions that were measured, which must be there.
[[nodiscard]] Study measured_study(const AppState& state);

class StudyFinder {
 public:
  /// `wake` is called from other threads when there is something new.
  explicit StudyFinder(const std::function<void()>& wake)
      : plan_job_({.wake = wake, .wake_for_progress = true}),
        changes_job_({.wake = wake}),
        line_job_({.wake = wake, .wake_for_progress = true}),
        solids_job_({.wake = wake, .wake_for_progress = true}),
        slides_job_({.wake = wake, .wake_for_progress = true}),
        pieces_job_({.wake = wake, .wake_for_progress = true}) {}

  /// A hand at settings: lines follow it one after the other, side actions and halves wait. `solids`: the
  /// halves are looked at.
  struct Wants {
    bool moving = false, solids = false;
  };
  // Call them every frame in this order, after the figures were updated.
  void find_actions(const AppState& state, ActionsState& actions, const Wants& wants);
  void find_mold(const AppState& state, MoldState& mold, const Wants& wants);
  /// Made anew only where what it says has changed, as finding the place of a fault walks over the whole
  /// mesh. While a direction moves the cards stay.
  void find_verdict(AppState& state);
  /// Gives up what runs.
  void cancel() {
    plan_job_.give_up();
    changes_job_.give_up();
    line_job_.give_up();
    solids_job_.give_up();
    slides_job_.give_up();
    pieces_job_.give_up();
  }

 private:
  /// What an answer depends on.
  template <typename Answer>
  using Inputs = std::pair<std::shared_ptr<const PartModel>, typename Asked<Answer>::Inputs>;
  template <typename Answer>
  static Inputs<Answer> inputs_of(const AppState& state) {
    return {state.model, Asked<Answer>::inputs(asked_study(state))};
  }
  struct FoundPlan {
    Study study;  // that knows the plan
    ActionBodies bodies;
  };
  static FoundPlan find_plan(Study study, const Progress& progress);
  void find_line(const AppState& state, MoldState& mold, bool moving);
  void find_solids(const AppState& state, MoldState& mold, const Wants& wants);
  /// Once halves and plan are there: both are made anew around what the plan moves.
  void find_slides(const AppState& state, MoldState& mold, const Wants& wants);
  void find_pieces(const AppState& state, MoldState& mold, bool moving);
  void find_cards(AppState& state);

  Job<FoundPlan> plan_job_;
  Job<std::shared_ptr<const Changes>> changes_job_;
  Job<MoldLine> line_job_;
  Job<MoldSolids> solids_job_, slides_job_;
  Job<std::vector<MoldOfPieces>> pieces_job_;
  // For which the job runs or has ended.
  std::optional<Inputs<ActionPlan>> plan_of_;
  std::optional<Inputs<DraftCheck>> line_of_;
  std::optional<Inputs<MoldHalves>> solids_of_;
  std::optional<std::pair<Inputs<PieceSolids>, Palette>> pieces_of_;
  std::shared_ptr<const SplitMesh> planned_, lined_;  // of which there is a plan, a line
  Asked<moldlight::MoldLine>::Inputs line_inputs_;    // of that line
  using Sources = std::array<std::shared_ptr<const void>, 3>;
  Sources slides_of_;   // the halves without slides, the plan, the split mesh
  Sources cards_of_;    // the sweep's result, plan and parting line; of these none while they are not settled
  Sources verdict_of_;  // the part, its plan where that is settled
  std::uint64_t verdict_figures_ = 0;
};

}  // namespace moldlight::gui
