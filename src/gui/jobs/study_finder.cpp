#include "gui/jobs/study_finder.hpp"

#include <utility>

#include "actions/actions_files.hpp"
#include "actions/mold_opening.hpp"
#include "pieces/pieces_report.hpp"
#include "sweep/mold_ranking.hpp"

namespace moldlight::gui {

Study asked_study(const AppState& state) {
  Questions questions;
  questions.query = state.settings;
  questions.with_actions = true;
  questions.actions = state.settings.actions;
  questions.mold = state.settings.mold;
  questions.required_draft_deg = state.settings.required_draft.deg;
  questions.finishes = state.settings.required_draft.finishes;
  return Study(state.model, std::move(questions));
}

Study measured_study(const AppState& state) {
  Study study = asked_study(state);
  SplitRegions regions{*state.figures.shown};
  regions.result.split = state.figures.split;
  study.keep(std::make_shared<const SplitRegions>(std::move(regions)));
  return study;
}

namespace {

bool is_measured(const AppState& state) {
  return state.model && state.figures.shown && state.figures.split && !state.figures.stale;
}

void forget_plan(ActionsState& actions) {
  actions.plan.reset();
  actions.bodies.reset();
  actions.changes.reset();
}

MoldLine shown_line(Study study, const Progress& progress) {
  MoldLine found{study.find<moldlight::MoldLine>(progress)};
  found.verdict = parting_verdict(found.assignment, found.line, study.model());
  found.frame = mold_frame(study.model(), found.assignment.direction);
  const UnitFrame& frame = study.model().frame;
  for (const PartingLoop& loop : found.line.loops) {
    std::vector<ViewSegment>& segments = found.loops.emplace_back();
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      segments.push_back(
          {frame.to_unit(loop.points[k]), frame.to_unit(loop.points[(k + 1) % loop.points.size()])});
  }
  if (study.questions().required_draft_deg > 0.0) found.draft = study.find<DraftCheck>(progress);
  return found;
}

/// How a solid that an action moves leaves its mold.
SteelMotion motion_of(const SideAction& action, double diagonal) {
  const bool first = goes_first(action);
  return {.half = !first             ? 0.0
                  : action.core_side ? 1.0
                                     : -1.0,
          .way = action.travel / diagonal * action.direction,
          .first = first};
}

/// With the slides and lifters of the study's plan, where that is known.
MoldSolids shown_solids(Study study, const Progress& progress) {
  const auto plan = study.known<ActionPlan>();
  static_cast<void>(study.find<MoldHalves>(progress));
  if (plan) static_cast<void>(study.find<MoldPieces>(progress));
  MoldSolids found{.plain = study.known<MoldHalves>(), .pieces = study.known<MoldPieces>(), .shown = {}};
  const MoldHalves& halves = found.halves();
  const UnitFrame& frame = study.model().frame;
  const auto show = [&](const MoldBody& body, Steel steel) -> ViewSolid& {
    return found.shown.emplace_back(view_solid(in_part(halves, body.mesh), frame, steel));
  };
  if (!halves.made()) return found;
  show(halves.core, Steel::core);
  show(halves.cavity, Steel::cavity);
  for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
    const MoldBody& body = halves.inserts[k];
    if (body.kind != PieceKind::insert) {
      ViewSolid& solid = show(body, Steel::moved);
      solid.body.colour = action_colour(body.action);
      solid.motion = motion_of(plan->actions[body.action], frame.diagonal);
    } else if (!plan || found.pieces->of_inserts[k].actions.empty()) {
      show(body, Steel::insert);  // what other actions form moves as their bodies
    }
  }
  return found;
}

/// For one number of directions after the other, until they are enough.
std::vector<MoldOfPieces> found_pieces(Study study, Palette palette, const Progress& progress) {
  std::vector<MoldOfPieces> all;
  const int most = PiecesSettings().most;
  for (int count = 2; count <= most && (all.empty() || !all.back().result->enough); ++count) {
    Questions questions = study.questions();
    questions.pieces.most = count;
    study.ask(std::move(questions));
    const PiecesResult& found = study.find<PiecesResult>(progress);
    const UnitFrame& frame = study.model().frame;
    auto bodies = std::make_shared<std::vector<ViewBody>>();
    TriangleMesh sheet{.vertices = found.formed.mesh.vertices, .facets = {}};
    for (std::size_t k = 0; k < found.count(); ++k) {
      sheet.facets.clear();
      for (std::size_t piece = 0; piece < found.formed.formed_by.size(); ++piece)
        if (found.formed.formed_by[piece] == k)
          sheet.facets.push_back(found.formed.mesh.pieces[piece].corners);
      bodies->push_back(view_body(sheet, frame, piece_colour(k, palette)));
    }
    all.push_back({study.known<PiecesResult>(), nullptr, bodies});
    if (!found.enough) continue;
    for (const StillBody& solid : pulled_pieces(study.model(), study.find<PieceSolids>(progress), palette))
      bodies->push_back(view_body(solid.mesh, frame, solid.colour));
    all.back().solids = study.known<PieceSolids>();
  }
  return all;
}

/// None while undercuts are not counted.
std::optional<Verdict> made_verdict(const AppState& state, const ActionPlan* plan) {
  const Figures& figures = state.figures;
  if (!state.model || !figures.shown || !figures.undercuts) return std::nullopt;
  if (plan != nullptr) return verdict_of(*state.model, *figures.shown, *plan);
  return verdict_of({.model = *state.model,
                     .regions = *figures.shown,
                     .undercuts = *figures.undercuts,
                     .actions = std::nullopt});
}

}  // namespace

StudyFinder::FoundPlan StudyFinder::find_plan(Study study, const Progress& progress) {
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

void StudyFinder::find_actions(const AppState& state, ActionsState& actions, const Wants& wants) {
  const Figures& figures = state.figures;
  // Of a direction that turns the undercuts are others in every frame.
  if (planned_ && planned_ != figures.split) {
    planned_.reset();
    forget_plan(actions);
  }
  const bool measured = is_measured(state);
  const auto inputs = state.model ? inputs_of<ActionPlan>(state) : Inputs<ActionPlan>();
  if (plan_of_ && (!measured || *plan_of_ != inputs)) {
    plan_job_.give_up();
    changes_job_.give_up();
    plan_of_.reset();
  }
  if (measured && !wants.moving && !plan_of_) {
    plan_of_ = inputs;
    actions.error.clear();
    plan_job_.start(
        [study = measured_study(state)](const Progress& progress) { return find_plan(study, progress); });
  }
  if (auto outcome = plan_job_.take()) {
    actions.error = std::move(outcome->error);
    forget_plan(actions);
    if (auto& found = outcome->result) {
      actions.plan = found->study.known<ActionPlan>();
      actions.bodies = std::make_shared<const ActionBodies>(std::move(found->bodies));
      changes_job_.start([study = std::move(found->study)](const Progress& progress) mutable {
        static_cast<void>(study.find<Changes>(progress));
        return study.known<Changes>();
      });
    }
    planned_ = figures.split;
    ++actions.revision;
  }
  if (auto outcome = changes_job_.take(); outcome && outcome->result)
    actions.changes = {*outcome->result, &(*outcome->result)->of_undercuts};
  actions.running = plan_job_.running() ? std::optional(plan_job_.status()) : std::nullopt;
  // Not while a hand holds what would change it.
  actions.awaited = state.model && figures.error.empty() && (plan_of_ ? plan_job_.running() : !wants.moving);
  actions.changes_awaited = changes_job_.running();
}

void StudyFinder::find_mold(const AppState& state, MoldState& mold, const Wants& wants) {
  // Of a direction that turns the line is another in every frame.
  if (lined_ && lined_ != state.figures.split) {
    lined_.reset();
    mold.line.reset();
    mold.solids.reset();
  }
  if (state.model) {
    find_line(state, mold, wants.moving);
    find_solids(state, mold, wants);
  }
  find_pieces(state, mold, wants.moving);
  mold.running.reset();
  if (pieces_job_.running()) mold.running = pieces_job_.status();
  if (slides_job_.running()) mold.running = slides_job_.status();
  if (solids_job_.running()) mold.running = solids_job_.status();
  if (line_job_.running()) mold.running = line_job_.status();
}

void StudyFinder::find_line(const AppState& state, MoldState& mold, bool moving) {
  const bool measured = is_measured(state);
  const auto inputs = inputs_of<DraftCheck>(state);
  const auto query_of = [](const Inputs<DraftCheck>& of) -> const ExactQuery& {
    return of.second.first.first;
  };
  const bool other = line_of_ != inputs;
  if (line_of_ && (!measured || query_of(*line_of_) != query_of(inputs) || (other && !moving))) {
    line_job_.give_up();
    line_of_.reset();
  }
  if (measured && other && !line_job_.running() && (!moving || mold.line)) {
    Study study = measured_study(state);
    // Another draft alone asks for no other line.
    if (mold.line && line_inputs_ == inputs.second.first && lined_ == state.figures.split)
      study.keep<moldlight::MoldLine>(mold.line);
    line_of_ = inputs;
    mold.error.clear();
    line_job_.start([study](const Progress& progress) { return shown_line(study, progress); });
  }
  if (auto outcome = line_job_.take()) {
    mold.error = std::move(outcome->error);
    mold.line.reset();
    if (outcome->result) mold.line = std::make_shared<const MoldLine>(std::move(*outcome->result));
    lined_ = state.figures.split;
    if (line_of_) line_inputs_ = line_of_->second.first;
  }
  mold.line_awaited = state.figures.error.empty() && (line_job_.running() || (!moving && line_of_ != inputs));
}

void StudyFinder::find_solids(const AppState& state, MoldState& mold, const Wants& wants) {
  const bool ready = mold.line && !mold.line_awaited;
  const auto inputs = inputs_of<MoldHalves>(state);
  const bool turned = solids_of_ && solids_of_->second.first != inputs.second.first;
  if (turned || (ready && solids_of_ && *solids_of_ != inputs) || (!wants.solids && solids_job_.running())) {
    solids_job_.give_up();
    solids_of_.reset();
  }
  if (ready && wants.solids && !wants.moving && !solids_of_) {
    solids_of_ = inputs;
    Study study = asked_study(state);
    study.keep<moldlight::MoldLine>(mold.line);
    solids_job_.start([study](const Progress& progress) { return shown_solids(study, progress); });
  }
  if (auto outcome = solids_job_.take()) {
    if (!outcome->error.empty()) mold.error = std::move(outcome->error);
    mold.solids.reset();
    if (outcome->result) mold.solids = std::make_shared<const MoldSolids>(std::move(*outcome->result));
  }
  find_slides(state, mold, wants);
  mold.solids_awaited =
      wants.solids && mold.error.empty() && state.figures.error.empty() &&
      (solids_of_ ? solids_job_.running() || slides_job_.running() || state.actions.awaited : !wants.moving);
}

void StudyFinder::find_slides(const AppState& state, MoldState& mold, const Wants& wants) {
  const auto plan = is_settled(state.actions) ? state.actions.plan : nullptr;
  const auto plain = mold.solids ? mold.solids->plain : nullptr;
  const Sources sources{plain, plan, state.figures.split};
  if (slides_of_ != sources || (!wants.solids && slides_job_.running())) {
    slides_job_.give_up();
    slides_of_ = {};
    if (wants.solids && !wants.moving && is_measured(state) && plan && plain && !plain->inserts.empty()) {
      slides_of_ = sources;
      Study study = measured_study(state);
      study.keep<moldlight::MoldLine>(mold.line);
      study.keep(plain);
      study.keep(plan);
      slides_job_.start([study](const Progress& progress) { return shown_solids(study, progress); });
    }
  }
  if (auto outcome = slides_job_.take()) {
    mold.error = std::move(outcome->error);
    if (outcome->result) mold.solids = std::make_shared<const MoldSolids>(std::move(*outcome->result));
  }
}

void StudyFinder::find_pieces(const AppState& state, MoldState& mold, bool moving) {
  const Palette palette = state.settings.look.palette;
  const bool wanted = state.model && state.mold_choices.pieces;
  if (pieces_of_ &&
      (wanted ? *pieces_of_ != std::pair(inputs_of<PieceSolids>(state), palette) : pieces_job_.running())) {
    pieces_job_.give_up();
    pieces_of_.reset();
    mold.pieces.clear();
  }
  if (wanted && !moving && !pieces_of_) {
    pieces_of_ = std::pair(inputs_of<PieceSolids>(state), palette);
    pieces_job_.start([study = asked_study(state), palette](const Progress& progress) {
      return found_pieces(study, palette, progress);
    });
  }
  if (auto outcome = pieces_job_.take()) {
    if (!outcome->error.empty()) mold.error = std::move(outcome->error);
    if (outcome->result) mold.pieces = std::move(*outcome->result);
  }
}

void StudyFinder::find_verdict(AppState& state) {
  const auto plan = is_settled(state.actions) ? state.actions.plan : nullptr;
  const Sources sources{state.model, plan};
  if (verdict_of_ != sources || verdict_figures_ != state.figures.revision) {
    state.verdict = made_verdict(state, plan.get());
    verdict_of_ = sources;
    verdict_figures_ = state.figures.revision;
  }
  find_cards(state);
}

void StudyFinder::find_cards(AppState& state) {
  const auto result = state.sweep.stale ? nullptr : state.sweep.result;
  const Figures& figures = state.figures;
  const auto& plan = state.actions.plan;
  const auto& line = state.mold.line;
  const bool settled =
      figures.shown && !figures.stale && is_settled(state.actions) && line && !state.mold.line_awaited;
  if (result && !settled && cards_of_[0] == result) return;
  const Sources sources{result, settled ? plan : nullptr, settled ? line : nullptr};
  if (cards_of_ == sources) return;
  cards_of_ = sources;
  std::optional<MoldCost> cost;
  if (settled)
    cost = mold_cost(*state.model, *figures.shown, direction_actions(*plan, *figures.shown),
                     line_figures(line->line));
  state.sweep.cards.clear();
  if (result)
    state.sweep.cards = direction_cards(*state.model, *result, state.settings.direction.unit(), cost);
}

}  // namespace moldlight::gui
