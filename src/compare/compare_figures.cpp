#include "compare/compare_figures.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

enum class Whole : std::uint8_t { none, area };

struct PartRow {
  std::string_view name;
  Whole whole = Whole::none;
  std::optional<double> (*of)(const ComparedPart&);
};

template <Region k_region>
std::optional<double> region_area(const ComparedPart& part) {
  return part.result.areas[k_region];
}

template <bool (*k_counts)(ActionKind)>
std::optional<double> count_actions(const ComparedPart& part) {
  if (!part.plan) return std::nullopt;
  return static_cast<double>(std::ranges::count_if(
      part.plan->actions, [](const SideAction& action) { return k_counts(action.kind); }));
}

bool any_action(ActionKind) { return true; }
bool is_lifter(ActionKind kind) { return kind == ActionKind::lifter; }

std::span<const PartRow> part_rows() {
  static const std::array<PartRow, 14> k_rows = {{
      {"undercut", Whole::area, region_area<Region::undercut>},
      {"core", Whole::area, region_area<Region::core>},
      {"cavity", Whole::area, region_area<Region::cavity>},
      {"both", Whole::area, region_area<Region::both>},
      {"total", Whole::area, [](const ComparedPart& p) { return std::optional(p.result.total_area); }},
      {"near-vertical", Whole::area,
       [](const ComparedPart& p) { return std::optional(p.result.near_vertical_area); }},
      {"reverse-draft", Whole::area,
       [](const ComparedPart& p) { return std::optional(p.result.reverse_draft.area); }},
      {"volume", Whole::none,
       [](const ComparedPart& p) {
         return p.model->health.closed ? std::optional(p.model->health.volume) : std::nullopt;
       }},
      {"undercuts", Whole::none,
       [](const ComparedPart& p) {
         return p.plan ? std::optional(static_cast<double>(p.plan->patches.size())) : std::nullopt;
       }},
      {"actions", Whole::none, count_actions<any_action>},
      {"slides", Whole::none, count_actions<is_slide>},
      {"lifters", Whole::none, count_actions<is_lifter>},
      {"travel", Whole::none,
       [](const ComparedPart& p) -> std::optional<double> {
         if (!p.plan) return std::nullopt;
         double most = 0.0;
         for (const SideAction& action : p.plan->actions) most = std::max(most, action.travel);
         return most;
       }},
      {"unreleased", Whole::area,
       [](const ComparedPart& p) { return p.plan ? std::optional(p.plan->unreleased_area) : std::nullopt; }},
  }};
  return k_rows;
}

struct ChangeRow {
  std::string_view name;
  Whole whole = Whole::none;
  MeasuredArea (*of)(const SurfaceChange&);
};

std::span<const ChangeRow> change_rows() {
  static const std::array<ChangeRow, 4> k_rows = {{
      {"gone", Whole::area, [](const SurfaceChange& s) { return s.gone; }},
      {"new", Whole::area, [](const SurfaceChange& s) { return s.fresh; }},
      {"places", Whole::none,
       [](const SurfaceChange& s) {
         return MeasuredArea{static_cast<double>(s.places.size()), 0.0};
       }},
      {"other-region", Whole::area,
       [](const SurfaceChange& s) {
         MeasuredArea sum;
         for (const ChangedRegion& region : s.regions) sum.area += region.area;
         return sum;
       }},
  }};
  return k_rows;
}

/// The commands whose reports have figures, with the schemas in which these stand where they stand now.
struct ReportKind {
  std::string_view command;
  int first_schema, last_schema;
};
constexpr std::array<ReportKind, 4> k_report_kinds = {
    {{"classify", 2, 2}, {"sweep", 2, 3}, {"actions", 1, 2}, {"mold", 2, 2}}};

std::size_t kind_of(std::string_view command) {
  const auto found = std::ranges::find(k_report_kinds, command, &ReportKind::command);
  CHECK(found != k_report_kinds.end());
  return static_cast<std::size_t>(found - k_report_kinds.begin());
}

/// Where each command's report has a figure, below a candidate in that of a sweep; empty where it has none.
/// Where that is an object, the figure is the sum of what is in it.
struct ReportRow {
  std::string_view name;
  std::array<std::string_view, k_report_kinds.size()> paths;
  Whole whole = Whole::none;
};

constexpr std::array<ReportRow, 24> k_report_rows = {{
    {"undercut",
     {"/areas/undercut", "/areas/undercut", "/verdict/undercut_area", "/assignment/action"},
     Whole::area},
    {"core", {"/areas/core", "/areas/core", "", "/assignment/core"}, Whole::area},
    {"cavity", {"/areas/cavity", "/areas/cavity", "", "/assignment/cavity"}, Whole::area},
    {"both", {"/areas/both", "/areas/both", "", ""}, Whole::area},
    {"total", {"/part/area", "", "/part/area", "/part/area"}, Whole::area},
    {"volume", {"/part/volume", "", "/part/volume", "/part/volume"}},
    {"near-vertical", {"/areas/near_vertical", "", "", ""}, Whole::area},
    {"projected-area", {"/projected_area", "/projected_area", "", ""}},
    {"projected-undercut", {"/projected_undercut", "/projected_undercut", "", ""}},
    {"reverse-draft",
     {"/draft/reverse/area", "/reverse_draft", "", "/assignment/reverse_draft"},
     Whole::area},
    {"undercuts", {"/verdict/undercuts", "/patches", "/verdict/undercuts", "/verdict/undercuts"}},
    {"unreleased",
     {"", "/unreleased_area", "/verdict/unreleased_area", "/verdict/unreleased_area"},
     Whole::area},
    {"actions", {"", "/verdict/actions", "/verdict/actions", "/verdict/actions"}},
    {"slides", {"", "/verdict/actions/slide", "/verdict/actions/slide", "/verdict/actions/slide"}},
    {"lifters", {"", "/verdict/actions/lifter", "/verdict/actions/lifter", "/verdict/actions/lifter"}},
    {"draw-depth", {"", "/draw_depth", "", ""}},
    {"undraughted-area", {"", "/undraughted_area", "", ""}, Whole::area},
    {"parting-climb", {"", "/parting_climb", "", "/loops/0/climb"}},
    {"parting-length", {"", "/parting_length", "", "/loops/0/length"}},
    {"steel-on-steel", {"", "", "", "/surfaces/contact"}},
    {"too-steep", {"", "", "", "/surfaces/too_steep"}},
    {"travel", {"", "/travel", "", ""}},
    {"side-actions", {"", "/side_actions", "", ""}},
    {"tilt-margin", {"", "/tilt_margin_deg", "", ""}},
}};

std::optional<double> number_at(const Json& json, std::string_view path) {
  const Json::json_pointer pointer{std::string(path)};
  if (!json.contains(pointer)) {
    // Of kinds of side actions a verdict counts those that there are.
    const bool counted = path.starts_with("/verdict/actions/") && json.contains(pointer.parent_pointer()) &&
                         json.at(pointer.parent_pointer()).is_object();
    return counted ? std::optional(0.0) : std::nullopt;
  }
  const Json& found = json.at(pointer);
  if (found.is_object()) {
    double sum = 0.0;
    for (const Json& each : found) sum += each.is_number() ? each.get<double>() : 0.0;
    return sum;
  }
  return found.is_number() ? std::optional(found.get<double>()) : std::nullopt;
}

/// What of the report has the figures.
const Json& figures_of(std::string_view command, const Json& report, std::string_view file) {
  const ReportKind& kind = k_report_kinds[kind_of(command)];
  bool known = false;
  for (int schema = kind.first_schema; schema <= kind.last_schema; ++schema)
    known = known || (report.is_object() && report.contains("schema") &&
                      report["schema"] == fmt::format("moldlight.{}/{}", command, schema));
  if (!known)
    throw UsageError(fmt::format("--baseline: {} is not a report of moldlight {} --json (moldlight.{}/{})",
                                 file, command, command, kind.last_schema));
  if (command != "sweep") return report;
  if (!report.contains("candidates") || !report["candidates"].is_array() || report["candidates"].empty())
    throw UsageError(fmt::format("--baseline: {} lists no direction", file));
  return report["candidates"][0];
}

}  // namespace

std::vector<std::string_view> comparison_figure_names() {
  std::vector<std::string_view> names;
  for (const PartRow& row : part_rows()) names.push_back(row.name);
  for (const ChangeRow& row : change_rows()) names.push_back(row.name);
  return names;
}

std::vector<ComparedFigure> comparison_figures(const Comparison& comparison) {
  const ComparedPart &a = comparison.a, &b = comparison.b;
  const auto whole = [&](Whole kind) { return kind == Whole::area ? b.result.total_area : 0.0; };
  std::vector<ComparedFigure> figures;
  for (const PartRow& row : part_rows()) {
    const auto before = row.of(a), after = row.of(b);
    if (!before || !after) continue;
    const double error =
        row.whole == Whole::area ? a.result.uncertainty.total() + b.result.uncertainty.total() : 0.0;
    figures.push_back({row.name, *before, *after, error, whole(row.whole)});
  }
  for (const ChangeRow& row : change_rows())
    figures.push_back({row.name, 0.0, row.of(comparison.surface).area, 0.0, whole(row.whole)});
  return figures;
}

std::vector<std::string_view> report_figure_names(std::string_view command) {
  std::vector<std::string_view> names;
  for (const ReportRow& row : k_report_rows)
    if (!row.paths[kind_of(command)].empty()) names.push_back(row.name);
  return names;
}

std::vector<ComparedFigure> report_figures(std::string_view command, const Json& before, const Json& after,
                                           std::string_view file) {
  const Json &was = figures_of(command, before, file), &is = figures_of(command, after, "this run");
  const double whole = number_at(after, "/part/area").value_or(0.0);
  const double doubt = number_at(was, "/undercut_uncertainty").value_or(0.0) +
                       number_at(is, "/undercut_uncertainty").value_or(0.0);
  std::vector<ComparedFigure> figures;
  for (const ReportRow& row : k_report_rows) {
    const std::string_view path = row.paths[kind_of(command)];
    if (path.empty()) continue;
    const auto old = number_at(was, path), now = number_at(is, path);
    if (!old || !now) continue;
    const bool area = row.whole == Whole::area;
    figures.push_back({row.name, *old, *now, area ? doubt : 0.0, area ? whole : 0.0});
  }
  return figures;
}

}  // namespace moldlight
