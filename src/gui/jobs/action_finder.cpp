#include "gui/jobs/action_finder.hpp"

#include <utility>

namespace moldlight::gui {

void ActionFinder::update(const AppState& state, ActionsState& actions, bool moving) {
  const Figures& figures = state.figures;
  // Of a direction that turns the undercuts are others in every frame.
  if (planned_ && planned_ != figures.split) {
    planned_.reset();
    actions.plan.reset();
  }
  const bool measured = state.model && figures.shown && figures.split && !figures.stale;
  const Inputs inputs{state.model, figures.split, state.settings.actions};
  if (asked_ && (!measured || *asked_ != inputs)) {
    job_.give_up();
    asked_.reset();
  }
  if (measured && !moving && !asked_) {
    asked_ = inputs;
    actions.error.clear();
    Classification result = *figures.shown;
    result.split = figures.split;
    job_.start([model = state.model, result = std::move(result), settings = inputs.settings](
                   const Progress& progress) { return find_actions(*model, result, settings, progress); });
  }
  if (auto outcome = job_.take()) {
    actions.error = std::move(outcome->error);
    actions.plan.reset();
    if (outcome->result) actions.plan = std::make_shared<const ActionPlan>(std::move(*outcome->result));
    planned_ = figures.split;
    ++actions.revision;
  }
  actions.running = job_.running() ? std::optional(job_.status()) : std::nullopt;
  actions.awaited = state.model && figures.error.empty() && (!asked_ || job_.running());
}

}  // namespace moldlight::gui
