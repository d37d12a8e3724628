// The report of a classification.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

/// How many undercuts, and what they have in all.
std::string undercut_text(const PartModel& model, const Classification& result, std::size_t count) {
  const double area = result.areas[Region::undercut];
  return fmt::format("{}: {} ± {} {}, {} of the surface",
                     count == 0 ? "Undercut in specks" : counted(count, "undercut"),
                     FigureColumn(result.total_area).text(area), error_text(result.uncertainty.total()),
                     powered_unit(model.part, 2), share_text(area, result.total_area));
}

}  // namespace

Report classify_report(const ReportContext& context, const Classification& result, const DraftShown& draft) {
  const PartModel& model = *context.model;
  const bool free = result.areas[Region::undercut] <= result.uncertainty.total();
  const Undercuts found = find_undercuts(model, *result.split, exact_query(model, result.query()));
  Report report = begin_report(context, "Parting direction", result.direction);
  report.tone = free ? Tone::good : Tone::attention;
  report.sentence = free ? "Two-plate mold: no undercut" : undercut_text(model, result, found.patches.size());
  if (!free) report.lead = "What is red can be released by neither half along this direction.";

  Illustrator pictures(context, result);
  report.still = {pictures.whole(), {}, "The part in the colours of its regions", view_caption()};
  report.view = region_view(context, result, pictures.to_viewer());
  report.sections.push_back(regions_section(context, result, ""));
  if (!found.patches.empty()) {
    std::vector<const Undercut*> undercuts;
    for (const Undercut& undercut : found.patches) undercuts.push_back(&undercut);
    Section section{"Undercuts", {}};
    section.blocks.emplace_back(undercut_table(context, pictures, undercuts, {}));
    report.sections.push_back(std::move(section));
  }
  report.sections.push_back(draft_section(context, draft));
  Pictures behind;
  behind.pictures.push_back({pictures.from_behind(), {}, "The part from the other side", {}});
  report.sections.push_back({"From the other side", {std::move(behind)}});
  report.sections.push_back(part_section(context, result.warnings));
  report.sections.push_back(repeat_section(context, classify_json(model, result)["settings"]));
  return report;
}

}  // namespace moldlight::report
