#include "gui/jobs/verdict_keeper.hpp"

namespace moldlight::gui {

namespace {

/// None while undercuts are not counted.
std::optional<Verdict> made_verdict(const AppState& state, const std::shared_ptr<const ActionPlan>& plan) {
  const Figures& figures = state.figures;
  if (!state.model || !figures.shown || !figures.undercuts) return std::nullopt;
  if (plan) return verdict_of(*state.model, *figures.shown, *plan);
  return verdict_of({.model = *state.model,
                     .regions = *figures.shown,
                     .undercuts = *figures.undercuts,
                     .actions = std::nullopt});
}

}  // namespace

void VerdictKeeper::update(AppState& state) {
  const Inputs inputs{state.model, state.figures.revision,
                      is_settled(state.actions) ? state.actions.plan : nullptr};
  if (made_of_ == inputs) return;
  state.verdict = made_verdict(state, inputs.plan);
  made_of_ = inputs;
}

}  // namespace moldlight::gui
