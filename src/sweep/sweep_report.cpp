#include "sweep/sweep_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"
#include "io/atomic_file.hpp"
#include "mold/direction.hpp"
#include "sweep/direction_figures.hpp"

namespace moldlight {

namespace {

Json settings_json(const SweepResult& result) {
  Json settings = options_json(method_options(), result.settings.method);
  // The direction is what is searched for, and the figures are exact.
  for (const char* key : {"readout", "samples"}) settings.erase(key);
  settings.update(options_json(sweep_options(), result.settings));
  if (seeks_actions(result.settings))
    settings.update(options_json(action_options(), result.settings.action_settings));
  // The report is the same whatever the number of threads.
  settings.erase("jobs");
  settings["engine_used"] = result.engine;
  return settings;
}

Json axis_json(const PartModel& model, const SweepCandidate& candidate) {
  if (!candidate.axis) return {};
  const Json classified = classify_json(model, candidate.axis->classification);
  return {{"direction", classified["direction"]},
          {"reason", candidate.axis->reason},
          {"angle_deg", candidate.axis->angle_deg},
          {"areas", classified["areas"]},
          {"reverse_draft", candidate.axis->classification.reverse_draft.area}};
}

Json beside_json(const std::optional<BesideDirection>& beside) {
  if (!beside) return {};
  Json json = {{"direction", point_json(beside->direction)},
               {"name", beside->name},
               {"angle_deg", beside->angle_deg},
               {"undercut", beside->undercut},
               {"actions", nullptr},
               {"side_actions", nullptr},
               {"outer_climb", beside->climb ? Json(*beside->climb) : Json()}};
  if (beside->actions) {
    json["actions"] = beside->actions->text();
    json["side_actions"] = beside->actions->weight;
  }
  return json;
}

Json recommended_json(const SweepResult& result) {
  if (!result.recommended) return {};
  const Recommendation& recommended = *result.recommended;
  return {{"direction", point_json(recommended.direction)},
          {"name", recommended.name},
          {"why", recommended.why},
          {"beside", beside_json(recommended.beside)},
          {"provisional", recommended.provisional}};
}

Json candidate_json(const PartModel& model, const SweepCandidate& candidate) {
  // One spelling of a classification: what the sweep says of a direction is taken from what classify says.
  const Json classified = classify_json(model, candidate.classification);
  const auto if_measured = [&](Json value) { return candidate.measured ? value : Json(); };
  const bool leans_somewhere = candidate.tilt && !candidate.tilt->at_least();
  const std::optional<Canonical>& canonical = candidate.candidate.canonical;
  Json sources = Json::array();
  for (const CandidateSource& source : candidate.candidate.sources) {
    sources.push_back(
        {{"kind", candidate_kind_name(source.kind)}, {"reason", source.reason}, {"share", source.share}});
  }
  Json json = {{"rank", candidate.rank},
               {"tie_group", candidate.tie_group},
               {"direction", classified["direction"]},
               {"name", direction_words(candidate.classification.direction)},
               {"canonical", canonical ? Json(canonical->name) : Json()},
               {"rank_reasons", candidate.rank_reasons},
               {"beside", beside_json(candidate.beside)},
               {"sources", sources},
               {"measured", candidate.measured},
               {"areas", classified["areas"]},
               {"fractions", classified["fractions"]},
               {"undercut_uncertainty", classified["undercut_uncertainty"]},
               {"uncertainty_parts", if_measured(classified["uncertainty_parts"])},
               {"projected_undercut", if_measured(classified["projected_undercut"])},
               {"identity", if_measured(classified["identity"])}};
  for (const DirectionFigure& row : direction_figures()) {
    if (row.use.classified) continue;
    Json value;
    const auto known = figure_value(row, candidate);
    if (known && row.kind == FigureKind::count)
      value = static_cast<std::size_t>(*known);
    else if (known)
      value = *known;
    json[std::string(row.key)] = value;
    if (!row.former.empty()) json[std::string(row.former)] = value;
  }
  json["actions"] = candidate.actions ? Json(candidate.actions->text()) : Json();
  json["tilt_toward"] = leans_somewhere ? point_json(candidate.tilt->toward) : Json();
  json["pareto"] = candidate.pareto;
  json["axis_beside"] = axis_json(model, candidate);
  return json;
}

/// Of what is open: for the proof of the best the caps alone, for all free directions with what they leave.
Json proof_json(const SweepProof& proof, bool with_undercuts) {
  Json open = Json::array();
  for (const OpenCap& each : proof.open) {
    Json cap = {{"direction", point_json(each.cap.direction)}, {"radius_deg", each.cap.radius_deg}};
    if (with_undercuts) cap["undercut"] = each.undercut ? Json(*each.undercut) : Json();
    open.push_back(std::move(cap));
  }
  return {{"grade", proof.grade == ProofGrade::area ? "area" : "samples"},
          {"epsilon", proof.epsilon},
          {"bound", proof.bound},
          {"bound_error", proof.bound_error},
          {"proved_share", proof.proved_share},
          {"open", open},
          {"cells", proof.looked_at},
          {"complete", proof.complete},
          {"proved", proof.holds},
          {"elapsed_s", proof.elapsed_s}};
}

}  // namespace

Json sweep_json(const PartModel& model, const SweepResult& result) {
  Json candidates = Json::array();
  for (const SweepCandidate& candidate : result.candidates) {
    candidates.push_back(candidate_json(model, candidate));
  }
  Json json = {{"schema", "moldlight.sweep/3"},
               {"part", part_json(model, model.warnings)},
               {"settings", settings_json(result)},
               {"evaluated", result.evaluated.size()},
               {"skipped", result.skipped},
               {"complete", result.complete},
               {"elapsed_s", result.elapsed_s},
               {"remarks", result.remarks},
               {"recommended", recommended_json(result)},
               {"candidates", candidates}};
  if (result.proof) json["proof"] = proof_json(*result.proof, false);
  if (result.all_free) json["all_free"] = proof_json(*result.all_free, true);
  return json;
}

void write_direction_csv(const std::string& path, const SweepResult& result) {
  AtomicFile file(path);
  file.write("x,y,z,kind,undercut,undercut_error,given_up\n");
  for (const EvaluatedDirection& d : result.evaluated) {
    file.write(fmt::format("{},{},{},{},{},{},{}\n", d.direction.x, d.direction.y, d.direction.z,
                           candidate_kind_name(d.kind), d.undercut, d.undercut_error, d.given_up ? 1 : 0));
  }
  file.commit();
}

}  // namespace moldlight
