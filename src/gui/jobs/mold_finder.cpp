#include "gui/jobs/mold_finder.hpp"

#include <utility>

#include "parting/make_halves.hpp"

namespace moldlight::gui {

namespace {

MoldSettings of_line(const MoldSettings& settings) {
  MoldSettings kept;
  kept.soft_deg = settings.soft_deg;
  kept.parting_height = settings.parting_height;
  kept.cosmetic = settings.cosmetic;
  return kept;
}

MoldSettings of_solids(MoldSettings settings) {
  const MoldSettings line = of_line({});
  settings.soft_deg = line.soft_deg;
  settings.parting_height = line.parting_height;
  settings.fill_undercut = line.fill_undercut;  // tells what is written
  return settings;
}

MoldLine find_line(const PartModel& model, const Query& query, const MoldSettings& settings,
                   const ReverseDraft& reverse, const Progress& progress) {
  MoldLine found{.query = query,
                 .settings = settings,
                 .assignment = assign_sides(model, query, settings, progress),
                 .line = {},
                 .verdict = {},
                 .loops = {},
                 .draft = {}};
  found.line = parting_line(found.assignment);
  found.verdict = parting_verdict(found.assignment, found.line, model.frame.diagonal);
  for (const PartingLoop& loop : found.line.loops) {
    std::vector<ViewSegment>& segments = found.loops.emplace_back();
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      segments.push_back({model.frame.to_unit(loop.points[k]),
                          model.frame.to_unit(loop.points[(k + 1) % loop.points.size()])});
  }
  if (const double required = query.method.tau_deg; required > 0.0)
    found.draft = check_draft(model, found.assignment, reverse, required);
  return found;
}

ViewSolid shown_solid(const MoldHalves& halves, const MoldBody& body, Steel steel, const UnitFrame& frame) {
  TriangleMesh mesh = body.mesh;
  for (glm::dvec3& vertex : mesh.vertices)
    vertex = halves.centre + halves.frame.to_part(vertex) / halves.scale;
  return view_solid(mesh, frame, steel);
}

MoldSolids find_solids(const PartModel& model, const MoldLine& line, const MoldSettings& settings,
                       const Progress& progress) {
  MoldSolids found{.halves = make_halves(model, line.assignment.direction,
                                         {line.assignment.height, &line.line}, settings, progress),
                   .written = {},
                   .shown = {}};
  found.written = found.halves.written;
  if (!found.halves.made()) return found;
  found.shown.push_back(shown_solid(found.halves, found.halves.core, Steel::core, model.frame));
  found.shown.push_back(shown_solid(found.halves, found.halves.cavity, Steel::cavity, model.frame));
  for (const MoldBody& insert : found.halves.inserts)
    found.shown.push_back(shown_solid(found.halves, insert, Steel::insert, model.frame));
  return found;
}

}  // namespace

void MoldFinder::update(const AppState& state, MoldState& mold, const Wants& wants) {
  // Of a direction that turns the line is another in every frame.
  if (found_for_ && found_for_ != state.figures.split) {
    found_for_.reset();
    mold.line.reset();
    mold.solids.reset();
  }
  update_line(state, mold, wants.moving);
  update_solids(state, mold, wants);
  update_inserts(state, mold);
  mold.running.reset();
  if (solids_job_.running()) mold.running = solids_job_.status();
  if (line_job_.running()) mold.running = line_job_.status();
}

void MoldFinder::update_line(const AppState& state, MoldState& mold, bool moving) {
  const Figures& figures = state.figures;
  const bool measured = state.model && figures.shown && figures.split && !figures.stale;
  const LineInputs inputs{state.model, figures.split, of_line(state.settings.mold)};
  const bool other = !line_of_ || *line_of_ != inputs;
  if (line_of_ && (!measured || line_of_->split != figures.split || (other && !moving))) {
    line_job_.give_up();
    line_of_.reset();
  }
  if (measured && other && !line_job_.running() && (!moving || mold.line)) {
    line_of_ = inputs;
    mold.error.clear();
    line_job_.start([model = state.model, query = Query(state.settings), settings = state.settings.mold,
                     reverse = figures.shown->reverse_draft](const Progress& progress) {
      return find_line(*model, query, settings, reverse, progress);
    });
  }
  if (auto outcome = line_job_.take()) {
    mold.error = std::move(outcome->error);
    mold.line.reset();
    if (outcome->result) mold.line = std::make_shared<const MoldLine>(std::move(*outcome->result));
    found_for_ = figures.split;
  }
  mold.line_awaited = state.model && figures.error.empty() &&
                      (line_job_.running() || (!moving && (!line_of_ || *line_of_ != inputs)));
}

void MoldFinder::update_solids(const AppState& state, MoldState& mold, const Wants& wants) {
  const auto& line = mold.line;
  const bool ready = line && !mold.line_awaited;
  const SolidInputs inputs{state.figures.split, line, of_solids(state.settings.mold)};
  const bool stale = solids_of_ && (solids_of_->split != inputs.split || (ready && *solids_of_ != inputs));
  if (stale || (!wants.solids && solids_job_.running())) {
    solids_job_.give_up();
    solids_of_.reset();
  }
  if (ready && wants.solids && !wants.moving && !solids_of_) {
    solids_of_ = inputs;
    solids_job_.start([model = state.model, inputs](const Progress& progress) {
      return find_solids(*model, *inputs.line, inputs.settings, progress);
    });
  }
  if (auto outcome = solids_job_.take()) {
    if (!outcome->error.empty()) mold.error = std::move(outcome->error);
    mold.solids.reset();
    if (outcome->result) mold.solids = std::make_shared<const MoldSolids>(std::move(*outcome->result));
  }
  mold.solids_awaited = wants.solids && mold.error.empty() && state.figures.error.empty() && state.model &&
                        (solids_of_ ? solids_job_.running() : !wants.moving);
}

void MoldFinder::update_inserts(const AppState& state, MoldState& mold) {
  const auto& plan = state.actions.plan;
  if (inserts_of_ != mold.solids || inserts_by_ != plan) {
    inserts_job_.give_up();
    mold.by_action.reset();
    inserts_of_ = mold.solids;
    inserts_by_ = plan;
    if (mold.solids && plan && state.figures.split && !mold.solids->halves.inserts.empty()) {
      inserts_job_.start([solids = mold.solids, plan, split = state.figures.split](const Progress&) {
        return actions_of_inserts(solids->halves, *split, *plan);
      });
    }
  }
  if (auto outcome = inserts_job_.take(); outcome && outcome->result)
    mold.by_action = std::make_shared<const std::vector<InsertActions>>(std::move(*outcome->result));
}

void MoldFinder::cancel() {
  inserts_job_.give_up();
  line_job_.give_up();
  solids_job_.give_up();
}

}  // namespace moldlight::gui
