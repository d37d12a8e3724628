#include "gui/jobs/action_finder.hpp"

#include <utility>

#include "actions/actions_files.hpp"
#include "gui/jobs/window_study.hpp"

namespace moldlight::gui {

ActionFinder::Found ActionFinder::find(Study study, const Progress& progress) {
  const ActionPlan& plan = study.find<ActionPlan>(progress);
  ActionBodies bodies;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const auto& body = plan.actions[k].body;
    if (!body) continue;
    bodies.bodies.push_back(view_body(*body->solid, study.model().frame, action_colour(k)));
    bodies.actions.push_back(k);
  }
  return {std::move(study), std::move(bodies)};
}

namespace {

void forget_plan(ActionsState& actions) {
  actions.plan.reset();
  actions.bodies.reset();
  actions.changes.reset();
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
  const Inputs inputs{
      state.model, state.model ? Asked<ActionPlan>::inputs(asked_study(state)) : Asked<ActionPlan>::Inputs()};
  if (asked_ && (!measured || *asked_ != inputs)) {
    cancel();
    asked_.reset();
  }
  if (measured && !moving && !asked_) {
    asked_ = inputs;
    actions.error.clear();
    job_.start([study = measured_study(state)](const Progress& progress) { return find(study, progress); });
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
    actions.plan = found->study.known<ActionPlan>();
    actions.bodies = std::make_shared<const ActionBodies>(std::move(found->bodies));
    changes_.start([study = std::move(found->study)](const Progress& progress) mutable {
      static_cast<void>(study.find<Changes>(progress));
      return study.known<Changes>();
    });
  }
  planned_ = figures.split;
  ++actions.revision;
}

void ActionFinder::take_changes(ActionsState& actions) {
  if (auto outcome = changes_.take(); outcome && outcome->result)
    actions.changes = {*outcome->result, &(*outcome->result)->of_patches};
}

}  // namespace moldlight::gui
