#include "study/study_reports.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/number_format.hpp"
#include "parting/draft/draft_report.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

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

ActionsReport actions_report(Study& study, const Progress& progress) {
  const Changes& changes = study.find<Changes>(progress);
  return {study.model(), study.find<SplitRegions>(progress).result, study.questions().actions,
          study.find<ActionPlan>(progress), changes.of_patches};
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
  if (study.questions().required_draft_deg > 0.0)
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

Json sweep_json_with_verdicts(const PartModel& model, const SweepResult& result) {
  Json json = sweep_json(model, result);
  for (std::size_t k = 0; k < result.candidates.size(); ++k)
    json["candidates"][k]["verdict"] = verdict_or_null(model, result.candidates[k]);
  json["verdict"] = result.candidates.empty() ? Json() : verdict_or_null(model, result.candidates.front());
  return json;
}

}  // namespace moldlight
