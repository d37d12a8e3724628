// The report of a classification.

#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

/// Of which a report that asks for no draft shows the histogram alone.
constexpr double k_histogram_deg = 1.0;

Section checked_draft_section(const ReportContext& context, const Study& study) {
  Study with_draft = study;
  Questions questions = study.questions();
  const bool asked = questions.required_draft_deg > 0.0;
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
  report.still = {pictures.whole(), {}, "The part in the colours of its regions", view_caption()};
  report.view = region_view(context, result, pictures.to_viewer());
  if (!found.patches.empty()) {
    std::vector<const Undercut*> undercuts;
    for (const Undercut& undercut : found.patches) undercuts.push_back(&undercut);
    Section section{"Undercuts", {}};
    section.blocks.emplace_back(undercut_table(context, pictures, undercuts));
    report.sections.push_back(std::move(section));
  }
  Pictures behind;
  behind.pictures.push_back({pictures.from_behind(), {}, "The part from the other side", {}});
  report.sections.push_back({"From the other side", {std::move(behind)}});
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
  if (context.drawn() || study.questions().required_draft_deg > 0.0)
    report.sections.push_back(checked_draft_section(context, study));
  report.sections.push_back(part_section(context, result.warnings));
  report.sections.push_back(repeat_section(context, classify_json(model, result)["settings"]));
  return report;
}

}  // namespace moldlight::report
