#include "study/study.hpp"

#include "parting/make_halves.hpp"

namespace moldlight {

namespace {

ExactQuery exact_inputs(const Study& study) { return exact_query(study.model(), study.questions().query); }

MoldSettings of_line(const MoldSettings& settings) {
  MoldSettings kept;
  kept.soft_deg = settings.soft_deg;
  kept.parting_height = settings.parting_height;
  kept.cosmetic = settings.cosmetic;
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

}  // namespace

Query Asked<Classification>::inputs(const Study& study) { return study.questions().query; }
std::shared_ptr<const Classification> Asked<Classification>::find(Study& study, const Progress& progress) {
  if (const auto split = study.known<SplitRegions>()) return {split, &split->result};
  return shared(classify_exact(study.model(), study.questions().query, progress));
}

Query Asked<SplitRegions>::inputs(const Study& study) { return study.questions().query; }
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
  for (FacetIndex facet = 0; facet < fractions.size(); ++facet) {
    if (fractions[facet][static_cast<std::size_t>(Region::undercut)] > 0.0) facets.push_back(facet);
  }
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

Asked<Changes>::Inputs Asked<Changes>::inputs(const Study& study) { return Asked<ActionPlan>::inputs(study); }
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
  Assignment assignment = assign_sides(study.model(), asked.query, asked.mold, progress);
  PartingLine line = parting_line(assignment);
  return std::make_shared<const MoldLine>(std::move(assignment), std::move(line));
}

Asked<MoldHalves>::Inputs Asked<MoldHalves>::inputs(const Study& study) {
  return {exact_inputs(study), of_solids(study.questions().mold)};
}
std::shared_ptr<const MoldHalves> Asked<MoldHalves>::find(Study& study, const Progress& progress) {
  const MoldLine& line = study.find<MoldLine>(progress);
  return shared(make_halves(study.model(), line.assignment.direction, {line.assignment.height, &line.line},
                            study.questions().mold, progress));
}

Asked<MoldPieces>::Inputs Asked<MoldPieces>::inputs(const Study& study) {
  return {Asked<MoldHalves>::inputs(study), Asked<ActionPlan>::inputs(study)};
}
std::shared_ptr<const MoldPieces> Asked<MoldPieces>::find(Study& study, const Progress& progress) {
  const MoldLine& line = study.find<MoldLine>(progress);
  const MoldHalves& halves = study.find<MoldHalves>(progress);
  const ActionPlan& plan = study.find<ActionPlan>(progress);
  const MeetingPlace place{line.assignment.height, &line.line};
  return shared(make_pieces({study.model(), halves, plan, *study.find<SplitRegions>(progress).result.split,
                             place, study.questions().mold},
                            progress));
}

Asked<DraftCheck>::Inputs Asked<DraftCheck>::inputs(const Study& study) {
  return {Asked<MoldLine>::inputs(study), study.questions().required_draft_deg};
}
std::shared_ptr<const DraftCheck> Asked<DraftCheck>::find(Study& study, const Progress& progress) {
  const Assignment& assignment = study.find<MoldLine>(progress).assignment;
  return shared(check_draft(study.model(), assignment, study.find<Classification>(progress).reverse_draft,
                            study.questions().required_draft_deg));
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

}  // namespace moldlight
