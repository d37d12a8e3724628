#include "study/study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/classify_report.hpp"
#include "classify/number_format.hpp"
#include "parting/make_halves.hpp"
#include "pieces/pieces_report.hpp"

namespace moldlight {

namespace {

ExactQuery exact_inputs(const Study& study) { return exact_query(study.model(), study.questions().query); }

MoldSettings of_line(const MoldSettings& settings) {
  MoldSettings kept;
  kept.soft_deg = settings.soft_deg;
  kept.parting_height = settings.parting_height;
  kept.cosmetic = settings.cosmetic;
  kept.planar_worth_pct = settings.planar_worth_pct;
  return kept;
}

/// What is written is no matter of what the halves are.
MoldSettings of_solids(MoldSettings settings) {
  settings.fill_undercut = MoldSettings{}.fill_undercut;
  return settings;
}

template <typename Answer>
std::shared_ptr<const Answer> shared(Answer answer) {
  return std::make_shared<const Answer>(std::move(answer));
}

Json verdict_or_null(const PartModel& model, const SweepCandidate& candidate) {
  const std::optional<Verdict> verdict = verdict_of(model, candidate);
  return verdict ? verdict_json(*verdict) : Json();
}

void add_best_direction(const Study& study, Json& json) {
  if (!study.questions().best) return;
  const auto& [direction, name, why, off_axis_deg, off_axis] = *study.questions().best;
  json["best_direction"] = {{"name", name},
                            {"why", why},
                            {"off_axis_deg", off_axis_deg},
                            {"off_axis", off_axis.empty() ? Json() : Json(off_axis)}};
}

}  // namespace

Query Asked<Classification>::inputs(const Study& study) { return study.questions().query; }
std::shared_ptr<const Classification> Asked<Classification>::find(Study& study, const Progress& progress) {
  if (const auto split = study.known<SplitRegions>()) return {split, &split->result};
  return shared(classify_exact(study.model(), study.questions().query, progress));
}

std::shared_ptr<const SplitRegions> Asked<SplitRegions>::find(Study& study, const Progress& progress) {
  const auto known = study.known<Classification>();
  if (known && known->split) return shared(SplitRegions{*known});
  Classification split = classify_exact(study.model(), study.questions().query, progress, true);
  if (!known) return shared(SplitRegions{std::move(split)});
  // Its figures may be those of another readout.
  SplitRegions regions{*known};
  regions.result.split = std::move(split.split);
  return shared(std::move(regions));
}

Asked<UndercutTotals>::Inputs Asked<UndercutTotals>::inputs(const Study& study) {
  return {exact_inputs(study), study.questions().actions.least_travel_mm};
}
std::shared_ptr<const UndercutTotals> Asked<UndercutTotals>::find(Study& study, const Progress& progress) {
  if (const auto plan = study.known<ActionPlan>()) return shared(undercut_totals(*plan));
  const auto [query, least_travel_mm] = inputs(study);
  const PartModel& model = study.model();
  const auto split = study.known<SplitRegions>();
  const auto regions = study.known<Classification>();
  const auto mesh = split ? split->result.split : regions ? regions->split : nullptr;
  if (mesh) return shared(totals_of(find_undercuts(model, *mesh, query, progress, least_travel_mm)));
  // Facets given by samples may miss some.
  if (study.questions().query.method.readout != Readout::exact)
    return shared(totals_of(find_undercuts(model, *study.find<SplitRegions>(progress).result.split, query,
                                           progress, least_travel_mm)));
  const FacetFractions& fractions = study.find<Classification>(progress).facet_fractions;
  std::vector<FacetIndex> facets;
  for (FacetIndex facet = 0; facet < fractions.size(); ++facet)
    if (fractions[facet][static_cast<std::size_t>(Region::undercut)] > 0.0) facets.push_back(facet);
  return shared(count_undercuts(model, {.query = query, .facets = facets, .least_travel_mm = least_travel_mm},
                                progress));
}

Asked<ActionPlan>::Inputs Asked<ActionPlan>::inputs(const Study& study) {
  return {exact_inputs(study), study.questions().actions};
}
std::shared_ptr<const ActionPlan> Asked<ActionPlan>::find(Study& study, const Progress& progress) {
  const Classification& result = study.find<SplitRegions>(progress).result;
  return shared(find_actions(study.model(), result, study.questions().actions, progress));
}

std::shared_ptr<const Changes> Asked<Changes>::find(Study& study, const Progress& progress) {
  const ActionPlan& plan = study.find<ActionPlan>(progress);
  return shared(Changes{find_changes(study.model(), study.find<SplitRegions>(progress).result,
                                     study.questions().actions, plan, progress)});
}

Asked<MoldLine>::Inputs Asked<MoldLine>::inputs(const Study& study) {
  return {exact_inputs(study), of_line(study.questions().mold)};
}
std::shared_ptr<const MoldLine> Asked<MoldLine>::find(Study& study, const Progress& progress) {
  const Questions& asked = study.questions();
  auto line = shared(find_mold_line(study.model(), asked.query, asked.mold, progress));
  if (line->assignment.lineless)
    throw Error(study.model().part.file +
                ": too many of its facets cross others to find a parting line; unite its bodies "
                "(--repair union), take one of them (--body), or raise --effort");
  return line;
}

Asked<MoldHalves>::Inputs Asked<MoldHalves>::inputs(const Study& study) {
  return {exact_inputs(study), of_solids(study.questions().mold)};
}
std::shared_ptr<const MoldHalves> Asked<MoldHalves>::find(Study& study, const Progress& progress) {
  const MoldLine& line = study.find<MoldLine>(progress);
  return shared(make_halves(study.model(), line.assignment.direction, meeting_place(line),
                            study.questions().mold, progress));
}

Asked<MoldPieces>::Inputs Asked<MoldPieces>::inputs(const Study& study) {
  return {Asked<MoldHalves>::inputs(study), Asked<ActionPlan>::inputs(study)};
}
std::shared_ptr<const MoldPieces> Asked<MoldPieces>::find(Study& study, const Progress& progress) {
  const MoldLine& line = study.find<MoldLine>(progress);
  const MoldHalves& halves = study.find<MoldHalves>(progress);
  const ActionPlan& plan = study.find<ActionPlan>(progress);
  const MeetingPlace place = meeting_place(line);
  return shared(make_pieces({study.model(), halves, plan, *study.find<SplitRegions>(progress).result.split,
                             place, study.questions().mold},
                            progress));
}

Asked<PiecesResult>::Inputs Asked<PiecesResult>::inputs(const Study& study) {
  return {exact_query(study.model(), {{}, study.questions().query.method}), study.questions().pieces};
}
std::shared_ptr<const PiecesResult> Asked<PiecesResult>::find(Study& study, const Progress& progress) {
  const Questions& asked = study.questions();
  return shared(find_pieces(study.model(), asked.query.method, asked.pieces, progress));
}

Asked<PieceSolids>::Inputs Asked<PieceSolids>::inputs(const Study& study) {
  return {Asked<PiecesResult>::inputs(study), of_solids(study.questions().mold)};
}
std::shared_ptr<const PieceSolids> Asked<PieceSolids>::find(Study& study, const Progress& progress) {
  const PiecesResult& result = study.find<PiecesResult>(progress);
  PieceSolids first;
  first.refusal = "no direction releases any of the surface";
  for (const std::size_t along : halves_directions(result)) {
    Questions of_halves = study.questions();
    of_halves.query.direction = result.directions[along].direction;
    MoldHalves halves = Study(study.shared_model(), std::move(of_halves)).find<MoldHalves>(progress);
    PieceSolids solids = piece_solids(study.model(), result, along, std::move(halves), progress);
    if (solids.refusal.empty()) return shared(std::move(solids));
    if (first.directions.empty()) first = std::move(solids);
  }
  return shared(std::move(first));
}

Asked<DraftCheck>::Inputs Asked<DraftCheck>::inputs(const Study& study) {
  return {Asked<MoldLine>::inputs(study), study.questions().draft()};
}
std::shared_ptr<const DraftCheck> Asked<DraftCheck>::find(Study& study, const Progress& progress) {
  const Assignment& assignment = study.find<MoldLine>(progress).assignment;
  return shared(check_draft(study.model(), assignment, study.find<Classification>(progress).reverse_draft,
                            study.questions().draft()));
}

SweepSettings Asked<SweepResult>::inputs(const Study& study) { return study.questions().sweep; }
std::shared_ptr<const SweepResult> Asked<SweepResult>::find(Study& study, const Progress& progress) {
  const Questions& asked = study.questions();
  return shared(run_sweep(study.shared_model(), asked.sweep, progress, asked.sweep_shows));
}

Verdict Study::verdict(const Progress& progress) {
  if (!questions_.with_actions)
    return verdict_of({.model = model(),
                       .regions = find<Classification>(progress),
                       .undercuts = find<UndercutTotals>(progress),
                       .actions = std::nullopt});
  const ActionPlan& plan = find<ActionPlan>(progress);
  return verdict_of(model(), find<Classification>(progress), plan);
}

ActionsReport actions_report(Study& study, const Progress& progress) {
  const Changes& changes = study.find<Changes>(progress);
  return {study.model(), study.find<SplitRegions>(progress).result, study.questions().actions,
          study.find<ActionPlan>(progress), changes.of_undercuts};
}

const MoldHalves& mold_halves(Study& study, const Progress& progress) {
  return study.questions().with_actions ? study.find<MoldPieces>(progress).halves
                                        : study.find<MoldHalves>(progress);
}

void keep_written(Study& study, WrittenMold written, const Progress& progress) {
  if (study.questions().with_actions) {
    MoldPieces pieces = study.find<MoldPieces>(progress);
    pieces.halves.written = std::move(written);
    study.keep(std::make_shared<const MoldPieces>(std::move(pieces)));
  } else {
    MoldHalves halves = study.find<MoldHalves>(progress);
    halves.written = std::move(written);
    study.keep(std::make_shared<const MoldHalves>(std::move(halves)));
  }
}

MoldReport mold_report(Study& study, const Progress& progress) {
  const MoldHalves& halves = mold_halves(study, progress);
  const MoldLine& line = study.find<MoldLine>(progress);
  const bool with_actions = study.questions().with_actions;
  return {study.model(),
          study.questions().query,
          study.questions().mold,
          line.assignment,
          line.line,
          halves,
          halves.written,
          with_actions ? &study.find<ActionPlan>(progress) : nullptr,
          with_actions ? &study.find<MoldPieces>(progress) : nullptr};
}

std::string mold_refusal(Study& study, const Progress& progress) {
  const MoldHalves& halves = mold_halves(study, progress);
  const PartingLine& line = study.find<MoldLine>(progress).line;
  if (!halves.written.refusal.empty())
    return refusal_text(study.model(), halves, halves.written,
                        halves.refused_at ? loop_near(line, *halves.refused_at) : std::string());
  if (study.questions().with_actions) return {};
  const std::string unfilled = unfilled_text(study.model(), study.questions().mold, halves);
  if (unfilled.empty()) return {};
  return "no halves are written: " + unfilled +
         "; --fill-undercut leaves them to inserts, moldlight actions finds side actions";
}

Verdict mold_verdict(Study& study, const Progress& progress) {
  Verdict verdict = study.verdict(progress);
  const MoldHalves& halves = mold_halves(study, progress);
  if (!halves.written.refusal.empty()) verdict.reasons.push_back(sentence_of(mold_refusal(study, progress)));
  for (const std::string& fault : half_faults(study.model(), halves))
    verdict.reasons.push_back(fmt::format("The halves are not certified: {}.", fault));
  return verdict;
}

std::vector<std::string> mold_warnings(Study& study, const Progress& progress) {
  std::vector<std::string> warnings = study.model().warnings;
  const std::vector<std::string>& more = study.find<MoldLine>(progress).assignment.warnings;
  warnings.insert(warnings.end(), more.begin(), more.end());
  return warnings;
}

Json classify_json(Study& study, const Progress& progress) {
  Json json = classify_json(study.model(), study.find<Classification>(progress));
  if (study.questions().draft().any())
    json["draft"] = draft_json(study.model(), study.find<DraftCheck>(progress));
  json["verdict"] = verdict_json(study.verdict(progress));
  add_best_direction(study, json);
  return json;
}

Json actions_json(Study& study, const Progress& progress) {
  Json json = actions_json(actions_report(study, progress));
  json["verdict"] = verdict_json(study.verdict(progress));
  add_best_direction(study, json);
  return json;
}

Json mold_json(Study& study, const Progress& progress) {
  Json json = mold_json(mold_report(study, progress));
  json["verdict"] = verdict_json(mold_verdict(study, progress));
  add_best_direction(study, json);
  return json;
}

Json pieces_json(Study& study, const Progress& progress) {
  const auto solids = study.known<PieceSolids>();
  return pieces_json(study.model(), study.find<PiecesResult>(progress), solids.get(), study.questions().mold);
}

void write_pieces(Study& study, const std::string& folder, const MoldFileSettings& settings,
                  const Progress& progress) {
  PieceSolids solids = study.find<PieceSolids>(progress);
  write_mold(folder, settings, study.model().part.unit, solids.halves.written);
  study.keep(std::make_shared<const PieceSolids>(std::move(solids)));
}

Json sweep_json(Study& study, const Progress& progress) {
  const PartModel& model = study.model();
  const SweepResult& result = study.find<SweepResult>(progress);
  Json json = sweep_json(model, result);
  for (std::size_t k = 0; k < result.candidates.size(); ++k)
    json["candidates"][k]["verdict"] = verdict_or_null(model, result.candidates[k]);
  json["verdict"] = result.candidates.empty() ? Json() : verdict_or_null(model, result.candidates.front());
  return json;
}

}  // namespace moldlight
