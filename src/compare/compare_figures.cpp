#include "compare/compare_figures.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace moldlight {

namespace {

using Kind = FigureKind;
using Found = std::optional<double>;

template <std::size_t k_number>
Found region_area(const ComparedPart& part) {
  return part.result.areas[k_regions[k_number]];
}
template <std::size_t... k_numbers>
std::vector<FigureRow<ComparedPart>> rows_of_regions(std::index_sequence<k_numbers...>) {
  return {{region_name(k_regions[k_numbers]), facts(k_regions[k_numbers]).title, Kind::area,
           region_area<k_numbers>}...};
}

/// Of a part whose side actions were asked for.
template <auto k_value>
Found of_plan(const ComparedPart& part) {
  return part.plan ? Found(static_cast<double>(std::invoke(k_value, *part.plan))) : std::nullopt;
}

template <bool (*k_counts)(ActionKind)>
std::ptrdiff_t action_count(const ActionPlan& plan) {
  return std::ranges::count_if(plan.actions, k_counts, &SideAction::kind);
}

bool any_action(ActionKind) { return true; }
bool is_lifter(ActionKind kind) { return kind == ActionKind::lifter; }
std::size_t undercut_count(const ActionPlan& plan) { return plan.undercuts.size(); }
double longest_travel(const ActionPlan& plan) {
  double most = 0.0;
  for (const SideAction& action : plan.actions) most = std::max(most, action.travel);
  return most;
}
/// What criteria know of a part beside its regions.
constexpr FigureRow<ComparedPart> k_plan_figures[] = {
    {k_verdict_figure, "", Kind::number,
     [](const ComparedPart& part) {
       return part.verdict ? Found(static_cast<double>(part.verdict->state)) : std::nullopt;
     }},
    {"volume", "", Kind::volume,
     [](const ComparedPart& part) {
       return part.model->health.closed ? Found(part.model->health.volume) : std::nullopt;
     }},
    {"undercuts", "", Kind::count, of_plan<undercut_count>},
    {"actions", "", Kind::count, of_plan<action_count<any_action>>},
    {"slides", "", Kind::count, of_plan<action_count<is_slide>>},
    {"lifters", "", Kind::count, of_plan<action_count<is_lifter>>},
    {"travel", "", Kind::length, of_plan<longest_travel>},
    {"unreleased", "", Kind::area, of_plan<&ActionPlan::unreleased_area>},
};

constexpr FigureRow<SurfaceChange> k_change_figures[] = {
    {"gone", "", Kind::area, member<&SurfaceChange::gone, &MeasuredArea::area>},
    {"new", "", Kind::area, member<&SurfaceChange::added, &MeasuredArea::area>},
    {"places", "", Kind::count,
     [](const SurfaceChange& surface) -> Found { return static_cast<double>(surface.places.size()); }},
    {"other_region", "", Kind::area, member<&SurfaceChange::other_region>},
};

/// Of what becomes of the mold.
constexpr FigureRow<Comparison> k_mold_figures[] = {
    {"steel_to_add", "", Kind::volume,
     [](const Comparison& c) { return c.mold ? Found(c.mold->to_add.volume) : std::nullopt; }},
    {"steel_to_cut", "", Kind::volume,
     [](const Comparison& c) { return c.mold ? Found(c.mold->to_cut.volume) : std::nullopt; }},
    {"parting_moved", "", Kind::length,
     [](const Comparison& c) {
       double most = 0.0;
       if (c.mold)
         for (const LineStretch& one : c.mold->line.added) most = std::max(most, one.farthest);
       return c.mold ? Found(most) : std::nullopt;
     }},
};

/// Of a part, in the order of their names.
std::vector<FoundFigure> part_figures(const ComparedPart& part) {
  std::vector<FoundFigure> figures = found_figures(region_figures(), part);
  std::erase_if(figures, [](const FoundFigure& figure) { return figure.kind == Kind::error; });
  std::ranges::copy(found_figures<ComparedPart>(k_plan_figures, part), std::back_inserter(figures));
  return figures;
}

/// The commands whose reports have figures, with the schemas in which these stand where they stand now.
struct ReportKind {
  std::string_view command;
  int first_schema, last_schema;
};
constexpr std::array<ReportKind, 4> k_report_kinds = {
    {{"classify", 2, 2}, {"sweep", 2, 3}, {"actions", 1, 2}, {"mold", 2, 2}}};

/// Its number; as many as there are for a command whose report has none.
std::size_t kind_of(std::string_view command) {
  const auto found = std::ranges::find(k_report_kinds, command, &ReportKind::command);
  return static_cast<std::size_t>(found - k_report_kinds.begin());
}

/// Where each command's report has a figure, below a candidate in that of a sweep; empty where it has none.
/// Where that is an object, the figure is the sum of what is in it.
struct ReportRow {
  std::string_view name;
  std::array<std::string_view, k_report_kinds.size()> paths;
  bool area = false;  // has a share of the part's, and its doubt
};

constexpr std::array<ReportRow, 24> k_report_rows = {{
    {k_verdict_figure, {"/verdict/state", "/verdict/state", "/verdict/state", "/verdict/state"}},
    {"undercut",
     {"/areas/undercut", "/areas/undercut", "/verdict/undercut_area", "/verdict/undercut_area"},
     true},
    {"core", {"/areas/core", "/areas/core", "", "/assignment/core"}, true},
    {"cavity", {"/areas/cavity", "/areas/cavity", "", "/assignment/cavity"}, true},
    {"both", {"/areas/both", "/areas/both", "", ""}, true},
    {"total", {"/part/area", "", "/part/area", "/part/area"}, true},
    {"volume", {"/part/volume", "", "/part/volume", "/part/volume"}},
    {"near-vertical", {"/areas/near_vertical", "/undraughted_area", "", ""}, true},
    {"projected-area", {"/projected_area", "/projected_area", "", ""}},
    {"projected-undercut", {"/projected_undercut", "/projected_undercut", "", ""}},
    {"reverse-draft", {"/draft/reverse/area", "/reverse_draft", "", "/assignment/reverse_draft"}, true},
    {"undercuts", {"/verdict/undercuts", "/patches", "/verdict/undercuts", "/verdict/undercuts"}},
    {"unreleased", {"", "/unreleased_area", "/verdict/unreleased_area", "/verdict/unreleased_area"}, true},
    {"actions", {"", "/verdict/actions", "/verdict/actions", "/verdict/actions"}},
    {"slides", {"", "/verdict/actions/slide", "/verdict/actions/slide", "/verdict/actions/slide"}},
    {"lifters", {"", "/verdict/actions/lifter", "/verdict/actions/lifter", "/verdict/actions/lifter"}},
    {"draw-depth", {"", "/draw_depth", "", ""}},
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
  if (found.is_string()) return verdict_number(found.get<std::string>());
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

std::span<const FigureRow<ComparedPart>> region_figures() {
  static const std::vector<FigureRow<ComparedPart>> k_rows = [] {
    auto rows = rows_of_regions(std::make_index_sequence<k_region_count>());
    rows.insert(
        rows.end(),
        {
            {"total", "Surface", Kind::area, member<&ComparedPart::result, &Classification::total_area>},
            {"near_vertical", "Near-vertical", Kind::area,
             member<&ComparedPart::result, &Classification::near_vertical_area>},
            {"reverse_draft", "Reverse draft", Kind::area,
             member<&ComparedPart::result, &Classification::reverse_draft, &ReverseDraft::area>},
            {"undercut_uncertainty", "", Kind::error,
             [](const ComparedPart& part) -> Found { return part.result.uncertainty.total(); }},
        });
    return rows;
  }();
  return k_rows;
}

std::vector<std::string_view> comparison_figure_names() {
  static const std::vector<std::string> k_names = [] {
    std::vector<std::string> names;
    const auto add = [&](const auto& rows) {
      for (const auto& row : rows)
        if (row.kind != Kind::error) std::ranges::replace(names.emplace_back(row.key), '_', '-');
    };
    add(region_figures());
    add(k_plan_figures);
    add(k_change_figures);
    add(k_mold_figures);
    return names;
  }();
  return {k_names.begin(), k_names.end()};
}

std::vector<ComparedFigure> comparison_figures(const Comparison& comparison) {
  const ComparedPart &a = comparison.a, &b = comparison.b;
  const double doubt = a.result.uncertainty.total() + b.result.uncertainty.total();
  const auto whole = [&](Kind kind) { return kind == Kind::area ? b.result.total_area : 0.0; };
  const auto was = part_figures(a), is = part_figures(b);
  const std::vector<std::string_view> names = comparison_figure_names();
  auto name = names.begin();
  std::vector<ComparedFigure> figures;
  for (std::size_t k = 0; k < was.size(); ++k, ++name)
    if (was[k].value && is[k].value)
      figures.push_back(
          {*name, *was[k].value, *is[k].value, was[k].kind == Kind::area ? doubt : 0.0, whole(was[k].kind)});
  for (const FigureRow<SurfaceChange>& row : k_change_figures)
    figures.push_back({*name++, 0.0, *row.find(comparison.surface), 0.0, whole(row.kind)});
  for (const FigureRow<Comparison>& row : k_mold_figures) {
    const double volume = row.kind == Kind::volume ? b.model->health.volume : 0.0;
    if (const Found found = row.find(comparison)) figures.push_back({*name, 0.0, *found, 0.0, volume});
    ++name;
  }
  return figures;
}

std::vector<std::string_view> report_figure_names(std::string_view command) {
  std::vector<std::string_view> names;
  const std::size_t kind = kind_of(command);
  for (const ReportRow& row : k_report_rows)
    if (kind < k_report_kinds.size() && !row.paths[kind].empty()) names.push_back(row.name);
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
    figures.push_back({row.name, *old, *now, row.area ? doubt : 0.0, row.area ? whole : 0.0});
  }
  return figures;
}

}  // namespace moldlight
