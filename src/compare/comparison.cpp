#include "compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "compare/criteria.hpp"
#include "mesh/length_unit.hpp"
#include "parting/planar_line.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {

namespace {

std::array<double, 3> sorted_extents(const PartModel& model) {
  const glm::dvec3 extent = model.health.bounds.max - model.health.bounds.min;
  std::array<double, 3> sorted = {extent.x, extent.y, extent.z};
  std::ranges::sort(sorted);
  return sorted;
}

/// What is said where B is larger or smaller than A by the ratio of two units; empty where it is not.
std::string unit_remark(const PartModel& a, const PartModel& b) {
  struct Ratio {
    double ratio;
    std::string_view units;
  };
  constexpr std::array<Ratio, 3> k_ratios = {{{25.4, "millimetres and inches"},
                                              {1000.0, "metres and millimetres"},
                                              {10.0, "centimetres and millimetres"}}};
  constexpr double k_alike = 1e-3;
  const auto extents_a = sorted_extents(a), extents_b = sorted_extents(b);
  for (const Ratio& one : k_ratios) {
    for (const bool larger : {true, false}) {
      const double factor = larger ? one.ratio : 1.0 / one.ratio;
      bool all = true;
      for (std::size_t k = 0; k < 3; ++k)
        all = all && std::abs(extents_b[k] - factor * extents_a[k]) <= k_alike * factor * extents_a[2];
      if (all)
        return fmt::format("B is {} times as {} as A in all extents: one is in another unit, such as {}",
                           real_text(one.ratio), larger ? "large" : "small", one.units);
    }
  }
  return {};
}

/// B in the unit of A, where the files of both name theirs and they differ; else B itself. Adds a remark
/// where it was converted, and where the parts' sizes are as far apart as two units.
std::shared_ptr<const PartModel> in_unit_of(const std::shared_ptr<const PartModel>& a,
                                            const std::shared_ptr<const PartModel>& b,
                                            std::vector<std::string>& remarks, const Progress& progress) {
  std::shared_ptr<const PartModel> converted = b;
  const auto unit_a = find_length_unit(a->part.unit), unit_b = find_length_unit(b->part.unit);
  if (unit_a && unit_b && unit_a->mm != unit_b->mm) {
    Part part = b->part;
    for (glm::dvec3& vertex : part.mesh.vertices) vertex *= unit_b->mm / unit_a->mm;
    part.unit = a->part.unit;
    converted = prepare_part(std::move(part), progress);
    remarks.push_back(fmt::format("B is in {}, A in {}: B was converted", b->part.unit, a->part.unit));
  }
  const std::string remark = unit_remark(*a, *converted);
  if (!remark.empty()) remarks.push_back(remark);
  return converted;
}

/// "2 new, 1 gone"; empty where all are the same.
std::string changes_text(const std::vector<MatchedChange>& changes) {
  std::vector<std::string> counts;
  for (const ChangeKind kind :
       {ChangeKind::added, ChangeKind::gone, ChangeKind::grown, ChangeKind::shrunk, ChangeKind::changed}) {
    const auto count = std::ranges::count(changes, kind, &MatchedChange::kind);
    if (count > 0) counts.push_back(fmt::format("{} {}", count, change_name(kind)));
  }
  return fmt::format("{}", fmt::join(counts, ", "));
}

/// Whether they are the same to the bit, so that whatever holds of one holds of the other.
bool are_equal(const PartModel& a, const PartModel& b) {
  return a.part.mesh.vertices == b.part.mesh.vertices && a.part.mesh.facets == b.part.mesh.facets &&
         a.part.facet_source == b.part.facet_source && a.part.unit == b.part.unit;
}

OverlayTolerance overlay_tolerance(const CompareSettings& settings, double diagonal) {
  OverlayTolerance tolerance = usual_tolerance(diagonal);
  if (settings.same_within > 0.0) tolerance.apart = settings.same_within;
  return tolerance;
}

/// "B is A × 1.0100 but for 2.5 % of the surface", "B is A × 25.4, as if A were in inches and B in mm"
std::string scale_text(const UniformScale& scale) {
  const auto units = mistaken_units(scale.factor);
  const std::string times = units
                                ? fmt::format("B is A × {:.4g}, as if A were in {} and B in {}", scale.factor,
                                              units->first.name == "in" ? "inches" : units->first.name,
                                              units->second.name == "in" ? "inches" : units->second.name)
                                : fmt::format("B is A × {:.4f}", scale.factor);
  return scale.other > 0.0 ? fmt::format("{} but for {:.1f} % of the surface", times, 100.0 * scale.other)
                           : times;
}

/// By the figures of the table and what criteria take for a change.
std::string undercut_text(const Comparison& comparison, const FigureStyle& style) {
  const Classification &a = comparison.a.result, &b = comparison.b.result;
  const double before = a.areas[Region::undercut], after = b.areas[Region::undercut];
  const std::string was = style.text(FigureKind::area, before), is = style.text(FigureKind::area, after),
                    unit = style.unit(FigureKind::area);
  const bool seen = !style.text(FigureKind::area, std::abs(after - before)).starts_with('<');
  if (was == is || !seen || std::abs(after - before) <= a.uncertainty.total() + b.uncertainty.total())
    return fmt::format("Undercut as before, {} {}", is, unit);
  const std::string change = change_percent(before, after);
  return fmt::format("Undercut {} {} {}, was {}{}{}", after > before ? "grew to" : "shrank to", is, unit, was,
                     change.empty() ? "" : ", ", change);
}

/// " ± 0.2" where it can be seen in the digits shown.
std::string seen_error(const MeasuredVolume& measured) {
  constexpr double k_seen_share = 5e-5;
  return measured.error > k_seen_share * measured.volume ? " ± " + error_text(measured.error) : std::string();
}

const ActionPlan* plan_of(const ComparedPart& part) { return part.plan ? &*part.plan : nullptr; }

void find_plan(const ActionSettings& settings, ComparedPart& part, const Progress& progress) {
  part.plan = find_actions(*part.model, part.result, settings, progress);
  part.verdict = verdict_of(*part.model, part.result, *part.plan);
}

void compare_molds(const OverlaySide& side_a, const OverlaySide& side_b, const ComparedQuery& query,
                   Comparison& comparison, const Progress& progress) {
  const ComparedPart &a = comparison.a, &b = comparison.b;
  if (!comparison.surface.closed) {
    comparison.remarks.emplace_back("The steel to cut and to add is not known, since a part is not closed");
    return;
  }
  const Assignment of_a = find_mold_line(*a.model, {query.a, a.result.settings}, {}, progress).assignment,
                   of_b = find_mold_line(*b.model, {query.b, b.result.settings}, {}, progress).assignment;
  if (of_a.lineless || of_b.lineless) {
    comparison.remarks.emplace_back(
        "Whether A's mold survives is not known, since too many facets of a part cross others");
    return;
  }
  MoldChange mold;
  mold.places =
      find_steel({side_a, of_a, plan_of(a)}, {side_b, of_b, plan_of(b)}, comparison.surface, progress);
  for (const PlaceSteel& place : mold.places)
    for (const auto& [part, sum] : {std::pair(&place.cut, &mold.to_cut), std::pair(&place.add, &mold.to_add)})
      if (*part) {
        sum->volume += (*part)->volume.volume;
        sum->error += (*part)->volume.error;
      }
  mold.line = find_line_change(parting_line(of_a), parting_line(of_b),
                               comparison.surface.tolerance.apart + comparison.surface.chords,
                               a.model->frame.diagonal);
  comparison.mold = std::move(mold);
}

void compare_plans(const PlannedSide& a, const PlannedSide& b, Comparison& comparison) {
  comparison.undercuts = match_undercuts(a, b, comparison.surface);
  comparison.actions = match_actions(a, b, comparison.undercuts, comparison.surface);
}

}  // namespace

std::span<const Option<CompareSettings>> compare_options() {
  using S = CompareSettings;
  static const std::vector<Option<S>> k_options = {
      {"align", "--align", "Align", "",
       "Turn and move B onto A before the comparison. Directions refer to A.", SwitchKind<S>{&S::align}},
      {"same_within", "--same-within", "Same within", "part's unit",
       "Largest distance between surfaces that count as the same. On curved faces, the error of both "
       "tessellations is added. The default is 1/10,000 of A's diagonal.",
       PositiveKind<S>{[](S& s) -> double& { return s.same_within; }}},
      {"actions", "--actions", "Side actions", "",
       "Compare the undercuts one by one, with their side actions", SwitchKind<S>{&S::with_actions}},
      {"mold", "--mold", "Mold", "",
       "Report whether A's mold survives: steel to cut and to add, and where the parting line moves. The "
       "default is on if --direction names a direction.",
       SwitchKind<S>{&S::with_mold}},
  };
  return k_options;
}

Comparison prepare_comparison(const std::shared_ptr<const PartModel>& a,
                              const std::shared_ptr<const PartModel>& b, const CompareSettings& settings,
                              const Progress& progress) {
  require_within_part("--same-within", settings.same_within, a->frame.diagonal);
  Comparison comparison;
  comparison.settings = settings;
  comparison.a.model = a;
  comparison.b.model = in_unit_of(a, b, comparison.remarks, progress);
  if (!settings.align) return comparison;
  if (are_equal(*a, *comparison.b.model)) {
    comparison.alignment.emplace();
    return comparison;
  }
  comparison.alignment = align(*a, *comparison.b.model, progress);
  comparison.scale = find_scale(*a, *comparison.b.model, comparison.alignment,
                                overlay_tolerance(settings, a->frame.diagonal).apart, progress);
  if (comparison.scale) comparison.alignment = align_scaled(*a, *comparison.b.model, *comparison.scale);
  comparison.b.model = moved_part(*comparison.b.model, *comparison.alignment, progress);
  if (comparison.alignment->mirrored) comparison.remarks.push_back("B is close to a mirror image of A");
  return comparison;
}

void compare_parts(Comparison& comparison, const ComparedQuery& query, const Progress& progress) {
  const std::shared_ptr<const PartModel>& a = comparison.a.model;
  const CompareSettings& settings = comparison.settings;
  const double diagonal = a->frame.diagonal;
  OverlayTolerance tolerance = overlay_tolerance(settings, diagonal);
  // Most of the surface lies as well as the alignment found.
  if (comparison.alignment)
    tolerance.rounding = std::max(tolerance.rounding, 3.0 * comparison.alignment->median);
  tolerance.rounding = std::min(tolerance.rounding, 0.1 * tolerance.apart);
  MethodSettings method = query.method;
  // One lateral tolerance for both, or near-vertical surface would change with the box.
  method.tolerance = lateral_tolerance(method, diagonal);
  method.couple_kernel = false;
  comparison.a.result = classify_exact(*a, {query.a, method}, progress, true);
  if (query.a == query.b && are_equal(*a, *comparison.b.model)) {
    comparison.b.result = comparison.a.result;
    const OverlaySide side(a, comparison.a.result);
    comparison.surface = no_surface_change(side, tolerance);
    if (settings.with_mold) comparison.mold.emplace();
    if (!settings.with_actions) return;
    find_plan(settings.actions, comparison.a, progress);
    comparison.b.plan = comparison.a.plan;
    comparison.b.verdict = comparison.a.verdict;
    const PlannedSide planned{side, *comparison.a.plan};
    compare_plans(planned, planned, comparison);
    return;
  }
  comparison.b.result = classify_exact(*comparison.b.model, {query.b, method}, progress, true);
  const OverlaySide side_a(a, comparison.a.result), side_b(comparison.b.model, comparison.b.result);
  comparison.surface = find_surface_change(side_a, side_b, tolerance, progress);
  if (!settings.align && !comparison.surface.places.empty())
    comparison.scale = find_scale(*a, *comparison.b.model, std::nullopt, tolerance.apart, progress);
  if (settings.with_actions) {
    find_plan(settings.actions, comparison.a, progress);
    find_plan(settings.actions, comparison.b, progress);
    compare_plans({side_a, *comparison.a.plan}, {side_b, *comparison.b.plan}, comparison);
  }
  if (settings.with_mold && query.a == query.b) compare_molds(side_a, side_b, query, comparison, progress);
}

Comparison compare_revisions(const std::shared_ptr<const PartModel>& a,
                             const std::shared_ptr<const PartModel>& b, const CompareQuestion& question,
                             const Progress& progress) {
  const bool given = question.choice == CompareDirection::given;
  CompareSettings settings = question.settings;
  settings.with_mold = settings.with_mold || given;
  Comparison comparison = prepare_comparison(a, b, settings, progress);
  const auto best = [&](const ComparedPart& part) {
    return Direction(best_direction(part.model, question.method, progress).direction);
  };
  ComparedQuery query{question.direction, question.direction, question.method};
  if (!given) query.a = query.b = best(comparison.a);
  if (question.choice == CompareDirection::each) query.b = best(comparison.b);
  compare_parts(comparison, query, progress);
  return comparison;
}

std::string steel_owner_text(const Comparison& comparison, const SteelOwner& owner) {
  if (owner.side != MoldSide::action) return std::string(side_name(owner.side));
  const std::optional<ActionPlan>& plan = (owner.of_b ? comparison.b : comparison.a).plan;
  if (!owner.action || !plan) return "side action";
  return action_title(*plan, *owner.action);
}

std::string steel_of_text(const Comparison& comparison, const SteelChange& steel) {
  constexpr double k_least_share = 0.05;
  double whole = 0.0;
  for (const OwnedArea& one : steel.of) whole += one.area;
  std::vector<std::string> names;
  for (const OwnedArea& one : steel.of)
    if (one.area >= k_least_share * whole) names.push_back(steel_owner_text(comparison, one.owner));
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string mold_change_text(const Comparison& comparison, const MoldChange& mold) {
  constexpr std::size_t k_most_named = 3;
  const FigureStyle style(*comparison.a.model);
  const auto cuts = static_cast<std::size_t>(
      std::ranges::count_if(mold.places, [](const PlaceSteel& one) { return one.cut.has_value(); }));
  std::vector<std::string> added;
  for (const PlaceSteel& place : mold.places) {
    if (!place.add) continue;
    added.push_back(fmt::format(
        "{}{} {} at ({}) {}, {}", style.text(FigureKind::volume, place.add->volume.volume),
        seen_error(place.add->volume), style.unit(FigureKind::volume), style.point(place.add->centre),
        length_unit(comparison.a.model->part), steel_of_text(comparison, *place.add)));
  }
  const std::size_t named = std::min(added.size(), k_most_named), count = added.size();
  std::string text = cuts + count == 0 ? "No steel of the mold changes."
                     : cuts == 0       ? "No steel is cut."
                                       : fmt::format("Steel is cut at {}.", plural(cuts, "place"));
  if (count > 0) {
    text += fmt::format(" Steel is added at {}: {}", plural(count, "place"),
                        fmt::join(added.begin(), added.begin() + static_cast<std::ptrdiff_t>(named), "; "));
    text += named < count ? fmt::format("; {} more.", count - named) : ".";
  } else if (cuts > 0) {
    text += " No steel is added.";
  }
  if (!mold.line.added.empty()) {
    const auto& stretches = mold.line.added;
    const auto farthest = std::ranges::max_element(stretches, {}, &LineStretch::farthest);
    text += fmt::format(" The parting line moves off the old one at {}, by at most {} at ({}) {}.",
                        plural(stretches.size(), "place"),
                        style.with_unit(FigureKind::length, farthest->farthest), style.point(farthest->at),
                        length_unit(comparison.a.model->part));
  } else if (!mold.line.gone.empty()) {
    text += fmt::format(" {} of the old parting line {} no longer used.",
                        plural(mold.line.gone.size(), "segment"), mold.line.gone.size() == 1 ? "is" : "are");
  }
  return text;
}

std::string comparison_verdict(const Comparison& comparison) {
  const SurfaceChange& surface = comparison.surface;
  const FigureStyle style(*comparison.a.model);
  const auto area = [&](double value) { return style.with_unit(FigureKind::area, value); };
  if (!surface.any())
    return fmt::format("Nothing changed: surface and regions are the same within {}.",
                       style.with_unit(FigureKind::length, surface.tolerance.apart));
  std::vector<std::string> facts;
  if (comparison.scale)
    facts.push_back(scale_text(*comparison.scale));
  else if (!surface.places.empty())
    facts.push_back(fmt::format("{} changed: {} of surface gone, {} new",
                                plural(surface.places.size(), "place"), area(surface.gone.area),
                                area(surface.added.area)));
  if (!surface.regions.empty()) {
    facts.push_back(
        fmt::format("{} of unchanged surface is of another region now", area(surface.other_region())));
  }
  facts.push_back(undercut_text(comparison, style));
  const std::string undercuts = changes_text(comparison.undercuts),
                    actions = changes_text(comparison.actions);
  if (!undercuts.empty()) facts.back() += fmt::format(" ({})", undercuts);
  if (comparison.a.plan && comparison.b.plan)
    facts.push_back(actions.empty()
                        ? fmt::format("Side actions as before: {}", actions_text(*comparison.b.plan))
                        : fmt::format("Side actions: {}, were {} ({})", actions_text(*comparison.b.plan),
                                      actions_text(*comparison.a.plan), actions));
  const std::string steel = comparison.mold ? " " + mold_change_text(comparison, *comparison.mold) : "";
  return fmt::format("{}.{}", fmt::join(facts, ". "), steel);
}

}  // namespace moldlight
