#include "gui/jobs/action_finder.hpp"

#include <utility>

#include "actions/action_body.hpp"
#include "actions/actions_files.hpp"

namespace moldlight::gui {

ActionFinder::Found ActionFinder::find(const Inputs& inputs, const Classification& result,
                                       const Progress& progress) {
  Found found{.plan = find_actions(*inputs.model, result, inputs.settings, progress), .bodies = {}};
  const std::size_t count = found.plan.actions.size();
  for (std::size_t k = 0; k < count; ++k) {
    progress.report("shaping what moves", static_cast<double>(k) / static_cast<double>(count));
    const auto body = action_body(*inputs.model, result, found.plan, k);
    if (!body) continue;
    found.bodies.bodies.push_back(view_body(*body, inputs.model->frame, action_colour(k)));
    found.bodies.actions.push_back(k);
  }
  return found;
}

namespace {

void forget_plan(ActionsState& actions) {
  actions.plan.reset();
  actions.bodies.reset();
  actions.changes.reset();
}

/// The classification that the actions are of, with its split mesh.
Classification split_result(const Figures& figures) {
  Classification result = *figures.shown;
  result.split = figures.split;
  return result;
}

}  // namespace

void ActionFinder::update(const AppState& state, ActionsState& actions, bool moving) {
  const Figures& figures = state.figures;
  // Of a direction that turns the undercuts are others in every frame.
  if (planned_ && planned_ != figures.split) {
    planned_.reset();
    forget_plan(actions);
  }
  const bool measured = state.model && figures.shown && figures.split && !figures.stale;
  const Inputs inputs{state.model, figures.split, state.settings.actions};
  if (asked_ && (!measured || *asked_ != inputs)) {
    cancel();
    asked_.reset();
  }
  if (measured && !moving && !asked_) {
    asked_ = inputs;
    actions.error.clear();
    job_.start([inputs, result = split_result(figures)](const Progress& progress) {
      return find(inputs, result, progress);
    });
  }
  take_plan(figures, actions);
  take_changes(actions);
  actions.running = job_.running() ? std::optional(job_.status()) : std::nullopt;
  // Not while a hand holds what would change it.
  actions.awaited = state.model && figures.error.empty() && (asked_ ? job_.running() : !moving);
  actions.changes_awaited = changes_.running();
}

void ActionFinder::take_plan(const Figures& figures, ActionsState& actions) {
  auto outcome = job_.take();
  if (!outcome) return;
  actions.error = std::move(outcome->error);
  forget_plan(actions);
  if (auto& found = outcome->result) {
    actions.plan = std::make_shared<const ActionPlan>(std::move(found->plan));
    actions.bodies = std::make_shared<const ActionBodies>(std::move(found->bodies));
    changes_.start(
        [inputs = *asked_, plan = actions.plan, result = split_result(figures)](const Progress& progress) {
          return find_changes(*inputs.model, result, inputs.settings, *plan, progress);
        });
  }
  planned_ = figures.split;
  ++actions.revision;
}

void ActionFinder::take_changes(ActionsState& actions) {
  if (auto outcome = changes_.take(); outcome && outcome->result)
    actions.changes = std::make_shared<const std::vector<ToBeFree>>(std::move(*outcome->result));
}

}  // namespace moldlight::gui
