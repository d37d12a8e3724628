// Reports of one parting direction and of the best of many.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "mold/direction.hpp"
#include "report/describe/parts.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_pictures.hpp"
#include "sweep/sweep_report.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight::report {

namespace {

/// Of which a report that asks for no draft shows the histogram alone.
constexpr double k_histogram_deg = 1.0;

Section checked_draft_section(const ReportContext& context, const Study& study) {
  Study with_draft = study;
  Questions questions = study.questions();
  const bool asked = questions.draft().any();
  if (!asked) questions.required_draft_deg = k_histogram_deg;
  with_draft.ask(std::move(questions));
  return draft_section(context, {with_draft.find<DraftCheck>(context.progress), asked});
}

/// The part to look at, its undercuts one by one, and its other side.
void add_pages(const ReportContext& context, Study& study, Report& report) {
  const PartModel& model = *context.model;
  const Classification& result = study.find<SplitRegions>(context.progress).result;
  const Undercuts found = find_undercuts(model, *result.split, exact_query(model, result.query()),
                                         context.progress, study.questions().actions.least_travel_mm);
  Illustrator pictures(context, result);
  std::vector<const Undercut*> undercuts;
  for (const Undercut& undercut : found.counted) undercuts.push_back(&undercut);
  const std::vector<StillCallout> callouts = undercut_callouts(*result.split, undercuts);
  report.still = {pictures.whole(callouts), {}, "The part in the colours of its regions", view_caption()};
  report.view = region_view(context, result, pictures.to_viewer(), callouts);
  add_live(context, result, {{with_minus(direction_words(result.direction)), result.direction, result.areas}},
           report);
  if (!undercuts.empty()) {
    Section section{"Undercuts", {}};
    section.add(undercut_table(context, pictures, undercuts, totals_of(found)));
    report.sections.push_back(std::move(section));
  }
  Pictures behind;
  behind.pictures.push_back({pictures.from_behind(), {}, "The part from the other side", {}});
  report.sections.push_back({"From the other side", {std::move(behind)}});
}

constexpr glm::ivec2 k_map_px(1280, 800);

Picture direction_map(const ReportContext& context, const SweepResult& result) {
  StillSettings still;
  still.size = k_map_px;
  Picture picture;
  picture.light = sweep_sphere_picture(*context.model, result, still);
  still.theme = Theme::dark;
  picture.dark = sweep_sphere_picture(*context.model, result, still);
  picture.text = "Map of the undercut area over all parting directions, with the best of them marked";
  picture.caption =
      "All parting directions in an equal-area map. Hatched: not tried. The table below lists the marked "
      "directions.";
  return picture;
}

/// Where the JSON report has a figure of a direction.
std::string key_of(const DirectionFigure& figure, std::size_t candidate) {
  const std::string place = fmt::format("/candidates/{}/", candidate);
  if (figure.key == "undercut") return place + "areas/undercut";
  return figure.use.classified ? "" : place + std::string(figure.key);
}

Table candidates_table(const PartModel& model, const SweepResult& result) {
  const std::vector<const DirectionFigure*> columns = figure_columns(result);
  std::vector<const DirectionFigure*> brief = columns;
  keep_brief(brief);
  Table table{{{"#"}, {"tie", true}, {"direction", true}}, {}};
  for (const DirectionFigure* column : columns)
    table.columns.push_back(
        {figure_heading(*column, model), column->kind == FigureKind::actions,
         std::ranges::count(brief, column) > 0 ? TableColumnRoom::any : TableColumnRoom::wide});
  for (const char* heading : {"Pareto", "vector", "why"})
    table.columns.push_back({heading, true, TableColumnRoom::wide});
  for (std::size_t k = 0; k < result.candidates.size(); ++k) {
    const SweepCandidate& candidate = result.candidates[k];
    const glm::dvec3& direction = candidate.classification.direction;
    Row row{{{fmt::format("{}", candidate.rank)}, {candidate.tie}, {with_minus(direction_words(direction))}}};
    for (const DirectionFigure* column : columns) {
      const std::string text =
          with_minus(figure_text(*column, model, candidate) + figure_aside(*column, candidate));
      const auto value = figure_value(*column, candidate);
      const std::string key = column->kind == FigureKind::actions ? "" : key_of(*column, k);
      row.cells.push_back(value && !key.empty() ? number(text, key, *value) : Value{text});
    }
    row.cells.push_back({candidate.pareto ? "*" : ""});
    row.cells.push_back({with_minus(direction_text(direction))});
    row.cells.push_back({reasons_text(candidate.candidate)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Section proof_section(const PartModel& model, const SweepProof& proof, const std::string& key,
                      std::string title) {
  const std::string area_unit = powered_unit(model.part, 2);
  Section section{std::move(title), {}, true};
  section.add(fmt::format("{} {} an undercut of at least {} {}, {}.",
                          proof.open.empty() ? "Every parting direction"
                                             : "Every parting direction outside of the caps below",
                          proof.holds ? "has" : "that was tried has", rounded(proof.bound), area_unit,
                          proof.grade == ProofGrade::area ? "by area" : "for the scoring samples"),
              proof.holds ? TextLook::normal : TextLook::notice);
  FigureGrid grid;
  grid.figures = {
      {"Bound",
       number(rounded(proof.bound), key + "/bound", proof.bound),
       area_unit,
       {},
       proof.bound_error > 0.0 ? error_text(proof.bound_error) : ""},
      {"Proved",
       number(fmt::format("{:.4f}", 100.0 * proof.proved_share), key + "/proved_share", proof.proved_share),
       "%", "of the half-sphere of directions"},
      {"Open", {fmt::format("{}", proof.open.size())}, proof.open.size() == 1 ? "cap" : "caps"},
      {"Proof", {proof.holds ? "holds" : "does not hold"}, {}, proof.complete ? "" : "a limit ended it"}};
  section.add(std::move(grid));
  constexpr std::size_t k_most_caps = 12;
  Table caps{{{"around", true}, {"radius"}, {"undercut " + area_unit}}, {}};
  for (std::size_t k = 0; k < std::min(proof.open.size(), k_most_caps); ++k) {
    const OpenCap& open = proof.open[k];
    caps.rows.push_back({{{with_minus(direction_text(open.cap.direction, 4))},
                          number(fmt::format("{:.3g}°", open.cap.radius_deg),
                                 fmt::format("{}/open/{}/radius_deg", key, k), open.cap.radius_deg),
                          {open.undercut ? rounded(*open.undercut) : std::string("–")}}});
  }
  if (proof.open.size() > k_most_caps) caps.rest = fmt::format("… {} in all.", proof.open.size());
  if (!caps.rows.empty()) section.add(std::move(caps));
  return section;
}

/// What of the best direction is shown beside its figures.
void show_best(const ReportContext& context, const SweepResult& result, Report& report) {
  const SweepCandidate& best = result.candidates.front();
  const PartModel& model = *context.model;
  report.subject = "best " + report.subject;
  if (const std::optional<Verdict> verdict = verdict_of(model, best)) {
    take_verdict(*verdict, report);
  } else {
    report.tone = Tone::attention;
    report.sentence = "The sweep ended before the undercuts of the best direction were counted.";
  }
  if (!context.drawn()) return;
  const Classification split =
      classify_exact(model, best.classification.query(), Progress(&context.progress), true);
  Illustrator pictures(context, split);
  report.still = {pictures.whole({}), {}, "The part with its best parting direction", view_caption()};
  report.view = region_view(context, split, pictures.to_viewer());
  if (!context.live) return;
  std::vector<LiveDirection> known;
  for (const SweepCandidate& candidate : result.candidates) {
    if (!candidate.measured) continue;
    const Classification& one = candidate.classification;
    const double undercut = one.areas[Region::undercut];
    known.push_back({with_minus(direction_words(one.direction)), one.direction, one.areas,
                     fmt::format("{} undercut, {}", FigureStyle(model).with_unit(FigureKind::area, undercut),
                                 share_text(undercut, one.total_area))});
  }
  add_live(context, split, std::move(known), report);
  if (report.live) report.live->sphere = sphere_texture(undercut_field(result));
}

}  // namespace

Report classify_report(const ReportContext& context, Study& study) {
  const PartModel& model = *context.model;
  const Classification& result = context.drawn() ? study.find<SplitRegions>(context.progress).result
                                                 : study.find<Classification>(context.progress);
  Report report = begin_report(context, "Parting direction", result.direction);
  take_verdict(study.verdict(context.progress), report);
  report.sections.push_back(regions_section(context, result, ""));
  if (context.drawn()) add_pages(context, study, report);
  if (context.drawn() || study.questions().draft().any())
    report.sections.push_back(checked_draft_section(context, study));
  report.sections.push_back(part_section(context, result.warnings));
  report.sections.push_back(repeat_section(context, classify_json(model, result)["settings"]));
  return report;
}

Report sweep_report(const ReportContext& context, Study& study) {
  const SweepResult& result = study.find<SweepResult>(context.progress);
  const PartModel& model = *context.model;
  const bool any = !result.candidates.empty();
  Report report =
      begin_report(context, "Parting directions",
                   any ? result.candidates.front().classification.direction : glm::dvec3(0, 0, 1));
  Pictures maps;
  if (context.drawn()) maps.pictures.push_back(direction_map(context, result));
  if (any) {
    show_best(context, result, report);
  } else {
    report.subject.clear();
    report.tone = Tone::bad;
    report.sentence = "No direction was measured to the end.";
    if (context.drawn()) report.still = maps.pictures.front();
  }
  report.lead.push_back(fmt::format("{} scored by {}, {} dropped as surely worse{}",
                                    plural(result.evaluated.size(), "direction"), result.engine,
                                    result.skipped, result.complete ? "." : "; the sweep is not complete."));
  Section directions{"Parting directions", {}};
  for (const std::string& remark : result.remarks) directions.add(with_minus(remark));
  directions.add(std::move(maps));
  if (any) directions.add(candidates_table(model, result));
  report.sections.push_back(std::move(directions));
  if (result.proof)
    report.sections.push_back(proof_section(model, *result.proof, "/proof", "Proof that none is better"));
  if (result.all_free)
    report.sections.push_back(
        proof_section(model, *result.all_free, "/all_free", "All directions that are free"));
  if (any) {
    Section best = regions_section(context, result.candidates.front().classification, "/candidates/0");
    best.title = "What forms the surface along the best";
    best.pages_only = true;
    report.sections.push_back(std::move(best));
  }
  report.sections.push_back(
      part_section(context, any ? result.candidates.front().classification.warnings : model.warnings));
  report.sections.push_back(repeat_section(context, sweep_json(model, result)["settings"]));
  return report;
}

}  // namespace moldlight::report
