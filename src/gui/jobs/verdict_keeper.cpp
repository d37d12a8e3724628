#include "gui/jobs/verdict_keeper.hpp"

#include "sweep/mold_ranking.hpp"

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
  if (made_of_ != inputs) {
    state.verdict = made_verdict(state, inputs.plan);
    made_of_ = inputs;
  }
  update_cards(state);
}

void VerdictKeeper::update_cards(AppState& state) {
  const auto result = state.sweep.stale ? nullptr : state.sweep.result;
  const Figures& figures = state.figures;
  const auto& plan = state.actions.plan;
  const auto& line = state.mold.line;
  const bool settled =
      figures.shown && !figures.stale && is_settled(state.actions) && line && !state.mold.line_awaited;
  if (result && !settled && cards_made_of_[0] == result) return;
  const std::array<std::shared_ptr<const void>, 3> inputs{result, settled ? plan : nullptr,
                                                          settled ? line : nullptr};
  if (cards_made_of_ == inputs) return;
  cards_made_of_ = inputs;
  std::optional<MoldCost> cost;
  if (settled)
    cost = mold_cost(*state.model, *figures.shown, direction_actions(*plan, figures.shown->lateral_tolerance),
                     line_figures(line->line));
  state.sweep.cards.clear();
  if (result)
    state.sweep.cards = direction_cards(*state.model, *result, state.settings.direction.unit(), cost);
}

}  // namespace moldlight::gui
