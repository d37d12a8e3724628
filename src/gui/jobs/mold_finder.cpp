#include "gui/jobs/mold_finder.hpp"

#include <utility>

#include "gui/jobs/window_study.hpp"

namespace moldlight::gui {

namespace {

MoldLine find_line(Study study, const Progress& progress) {
  const auto& [assignment, line] = study.find<moldlight::MoldLine>(progress);
  const Questions& asked = study.questions();
  MoldLine found{.query = asked.query,
                 .settings = asked.mold,
                 .assignment = assignment,
                 .line = line,
                 .verdict = parting_verdict(assignment, line, study.model()),
                 .loops = {},
                 .draft = {}};
  const UnitFrame& frame = study.model().frame;
  for (const PartingLoop& loop : line.loops) {
    std::vector<ViewSegment>& segments = found.loops.emplace_back();
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      segments.push_back(
          {frame.to_unit(loop.points[k]), frame.to_unit(loop.points[(k + 1) % loop.points.size()])});
  }
  if (asked.required_draft_deg > 0.0) found.draft = study.find<DraftCheck>(progress);
  return found;
}

ViewSolid shown_solid(const MoldHalves& halves, const MoldBody& body, Steel steel, const UnitFrame& frame) {
  TriangleMesh mesh = body.mesh;
  for (glm::dvec3& vertex : mesh.vertices)
    vertex = halves.centre + halves.frame.to_part(vertex) / halves.scale;
  return view_solid(mesh, frame, steel);
}

MoldSolids find_solids(Study study, const MoldLine& line, const Progress& progress) {
  study.keep(std::make_shared<const moldlight::MoldLine>(line.assignment, line.line));
  const MoldHalves& halves = study.find<MoldHalves>(progress);
  const PartModel& model = study.model();
  MoldSolids found{.halves = halves, .written = halves.written, .shown = {}};
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
  if (!state.model) {
    line_job_.give_up();
    line_of_.reset();
    mold.line_awaited = false;
    return;
  }
  const Figures& figures = state.figures;
  const bool measured = state.model && figures.shown && figures.split && !figures.stale;
  const LineInputs inputs{state.model, Asked<moldlight::MoldLine>::inputs(asked_study(state)),
                          state.settings.required_draft.deg};
  const bool other = !line_of_ || *line_of_ != inputs;
  if (line_of_ && (!measured || line_of_->asked.first != inputs.asked.first || (other && !moving))) {
    line_job_.give_up();
    line_of_.reset();
  }
  if (measured && other && !line_job_.running() && (!moving || mold.line)) {
    line_of_ = inputs;
    mold.error.clear();
    line_job_.start(
        [study = measured_study(state)](const Progress& progress) { return find_line(study, progress); });
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
  if (!state.model) {
    solids_job_.give_up();
    solids_of_.reset();
    mold.solids_awaited = false;
    return;
  }
  const auto& line = mold.line;
  const bool ready = line && !mold.line_awaited;
  const SolidInputs inputs{line, Asked<MoldHalves>::inputs(asked_study(state))};
  const bool turned = solids_of_ && solids_of_->asked.first != inputs.asked.first;
  const bool stale = turned || (ready && solids_of_ && *solids_of_ != inputs);
  if (stale || (!wants.solids && solids_job_.running())) {
    solids_job_.give_up();
    solids_of_.reset();
  }
  if (ready && wants.solids && !wants.moving && !solids_of_) {
    solids_of_ = inputs;
    solids_job_.start([study = asked_study(state), line](const Progress& progress) {
      return find_solids(study, *line, progress);
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
