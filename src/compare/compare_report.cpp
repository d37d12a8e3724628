#include "compare/compare_report.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/figures.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "compare/compare_texts.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

/// The table lists no more places of a kind; JSON has all.
constexpr std::size_t k_most_rows = 12;

Json vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json alignment_json(const Alignment& alignment) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({alignment.rotation[0][row], alignment.rotation[1][row], alignment.rotation[2][row]});
  return {
      {"rotation", rows},
      {"shift", vector_json(alignment.shift)},
      {"residual", {{"rms", alignment.rms}, {"largest", alignment.largest}, {"median", alignment.median}}},
      {"mirrored", alignment.mirrored}};
}

Json area_json(const MeasuredArea& measured) { return {{"area", measured.area}, {"error", measured.error}}; }

Json areas_json(const Classification& result) {
  Json json;
  for (const Region region : k_regions) json[std::string(region_name(region))] = result.areas[region];
  json["total"] = result.total_area;
  json["near_vertical"] = result.near_vertical_area;
  json["reverse_draft"] = result.reverse_draft.area;
  json["undercut_uncertainty"] = result.uncertainty.total();
  return json;
}

Json difference_json(const Json& a, const Json& b) {
  Json json;
  for (const auto& [key, value] : a.items())
    if (key != "undercut_uncertainty") json[key] = b[key].get<double>() - value.get<double>();
  return json;
}

Json places_json(const Comparison& comparison) {
  const bool closed = comparison.a.model->health.closed && comparison.b.model->health.closed;
  Json list = Json::array();
  for (const ChangedPlace& place : comparison.surface.places) {
    list.push_back({{"gone", area_json(place.gone)},
                    {"new", area_json(place.fresh)},
                    {"volume", closed ? Json(place.volume) : Json()},
                    {"centre", vector_json(place.centre)},
                    {"bounds", bounds_json(place.bounds)}});
  }
  return list;
}

Json changed_regions_json(const SurfaceChange& surface) {
  Json list = Json::array();
  for (const ChangedRegion& region : surface.regions) {
    list.push_back({{"from", region_name(region.from)},
                    {"to", region_name(region.to)},
                    {"area", region.area},
                    {"centre", vector_json(region.centre)},
                    {"bounds", bounds_json(region.bounds)}});
  }
  return list;
}

Json undercut_json(const UndercutReport& patch) {
  const Undercut& undercut = patch.undercut;
  return {{"area", undercut.area},
          {"depth", std::isfinite(patch.depth) ? Json(patch.depth) : Json()},
          {"centre", vector_json(undercut.centre)},
          {"size_across", undercut.size_across},
          {"size_along", undercut.size_along}};
}

Json action_json(const SideAction& action) {
  return {{"kind", facts(action.kind).name},
          {"direction", vector_json(action.direction)},
          {"travel", action.travel},
          {"area", action.area}};
}

/// `former` and `fresh` are what the numbers count; `id` from 1, as `moldlight actions` counts them.
template <typename T, typename ToJson>
Json changes_json(const std::vector<MatchedChange>& changes, const std::vector<T>& former,
                  const std::vector<T>& fresh, const ToJson& to_json) {
  const auto side = [&](const std::vector<T>& all, const std::optional<std::size_t>& number) {
    if (!number) return Json();
    Json json = {{"id", *number + 1}};
    json.update(to_json(all[*number]));
    return json;
  };
  Json list = Json::array();
  for (const MatchedChange& change : changes)
    list.push_back({{"change", change_name(change.kind)},
                    {"a", side(former, change.former)},
                    {"b", side(fresh, change.fresh)}});
  return list;
}

std::string more_text(std::size_t count) {
  return count > k_most_rows ? fmt::format("… {} in all; --json has them\n", count) : "";
}

class Table {
 public:
  explicit Table(const Comparison& comparison)
      : comparison_(comparison),
        area_unit_(powered_unit(comparison.a.model->part, 2)),
        areas_(std::max(comparison.a.result.total_area, comparison.b.result.total_area)),
        lengths_(100.0 * comparison.a.model->frame.diagonal) {}

  [[nodiscard]] std::string heading() const {
    const ComparedPart &a = comparison_.a, &b = comparison_.b;
    std::string text = fmt::format("A  {}: {} facets, {} {}\nB  {}: {} facets, {} {}\n",
                                   part_name(a.model->part), a.model->health.facets,
                                   areas_.text(a.result.total_area), area_unit_, part_name(b.model->part),
                                   b.model->health.facets, areas_.text(b.result.total_area), area_unit_);
    const bool same = a.result.direction == b.result.direction;
    text += fmt::format("direction {}{}; the same within {} {}\n", figures(a.result.direction, 1.0),
                        same ? "" : " of A, " + figures(b.result.direction, 1.0) + " of B",
                        figure(comparison_.surface.tolerance.apart), length_unit(a.model->part));
    if (const auto& alignment = comparison_.alignment)
      text += fmt::format("B was laid on A: off by {} rms, {} at most, half of it by {} or less\n",
                          error_text(alignment->rms), error_text(alignment->largest),
                          error_text(alignment->median));
    return text;
  }

  [[nodiscard]] std::string places() const {
    const SurfaceChange& surface = comparison_.surface;
    if (surface.places.empty()) return "No surface is new or gone.\n";
    std::string text =
        fmt::format("{:<5} {:>11} {:>11} {:>11}  {:<26} {}\n", "place", "gone " + area_unit_,
                    "new " + area_unit_, powered_unit(comparison_.a.model->part, 3), "centre", "across");
    const bool closed = comparison_.a.model->health.closed && comparison_.b.model->health.closed;
    for (std::size_t k = 0; k < std::min(surface.places.size(), k_most_rows); ++k) {
      const ChangedPlace& place = surface.places[k];
      text += fmt::format("{:<5} {:>10} {:>10} {:>10}  {:<26} {}\n", k + 1, areas_.text(place.gone.area),
                          areas_.text(place.fresh.area), closed ? change_text(areas_, place.volume) : "",
                          point_text(lengths_, place.centre), lengths_.text(place.bounds.diagonal()));
    }
    text += more_text(surface.places.size());
    return text + fmt::format("all   {:>10} {:>10}             ± {} and {}\n", areas_.text(surface.gone.area),
                              areas_.text(surface.fresh.area), error_text(surface.gone.error),
                              error_text(surface.fresh.error));
  }

  [[nodiscard]] std::string regions() const {
    const Classification &a = comparison_.a.result, &b = comparison_.b.result;
    std::string text = fmt::format("{:<13} {:>13} {:>13} {:>13} {:>10}\n", "region", "A " + area_unit_,
                                   "B " + area_unit_, "change", "of A");
    const auto row = [&](std::string_view name, double before, double after) {
      text += fmt::format("{:<13} {:>12} {:>12} {:>13} {:>10}\n", name, areas_.text(before),
                          areas_.text(after), change_text(areas_, after - before),
                          before > 0.0 ? fmt::format("{:+.2f} %", 100.0 * (after - before) / before) : "");
    };
    for (const Region region : k_regions) row(region_name(region), a.areas[region], b.areas[region]);
    row("total", a.total_area, b.total_area);
    row("near-vertical", a.near_vertical_area, b.near_vertical_area);
    row("reverse draft", a.reverse_draft.area, b.reverse_draft.area);
    return text;
  }

  [[nodiscard]] std::string changed_regions() const {
    const auto& regions = comparison_.surface.regions;
    if (regions.empty()) return "";
    std::string text =
        fmt::format("{:<22} {:>11}  {:<26} {}\n", "surface that is in both", area_unit_, "centre", "across");
    for (std::size_t k = 0; k < std::min(regions.size(), k_most_rows); ++k) {
      const ChangedRegion& region = regions[k];
      text += fmt::format("{:<23} {:>10}  {:<26} {}\n",
                          fmt::format("{}, now {}", region_name(region.from), region_name(region.to)),
                          areas_.text(region.area), point_text(lengths_, region.centre),
                          lengths_.text(region.bounds.diagonal()));
    }
    return text + more_text(regions.size());
  }

  [[nodiscard]] std::string undercuts() const {
    const auto &before = comparison_.a.plan->patches, &after = comparison_.b.plan->patches;
    std::vector<MatchedChange> changes = comparison_.undercuts;
    const auto same =
        std::erase_if(changes, [](const MatchedChange& c) { return c.kind == ChangeKind::same; });
    std::string text =
        fmt::format("undercuts: {} and {}, {} of them the same\n", before.size(), after.size(), same);
    if (changes.empty()) return text;
    const std::string unit = length_unit(comparison_.a.model->part);
    text += fmt::format("{:<7} {:>10} {:>10} {:>9} {:>9}  {}\n", "", "A " + area_unit_, "B " + area_unit_,
                        "A deep", "B deep", "centre");
    for (std::size_t k = 0; k < std::min(changes.size(), k_most_rows); ++k) {
      const UndercutReport* was = changes[k].former ? &before[*changes[k].former] : nullptr;
      const UndercutReport* now = changes[k].fresh ? &after[*changes[k].fresh] : nullptr;
      const auto area = [&](const UndercutReport* one) {
        return one ? areas_.text(one->undercut.area) : "-";
      };
      const auto depth = [&](const UndercutReport* one) {
        return one && std::isfinite(one->depth) ? lengths_.text(one->depth) : "-";
      };
      text += fmt::format("{:<7} {:>9} {:>9} {:>9} {:>9}  {}\n", change_name(changes[k].kind), area(was),
                          area(now), depth(was), depth(now),
                          point_text(lengths_, (now ? now : was)->undercut.centre));
    }
    return text + more_text(changes.size());
  }

  [[nodiscard]] std::string actions() const {
    const auto &before = comparison_.a.plan->actions, &after = comparison_.b.plan->actions;
    if (before.empty() && after.empty()) return "side actions: none\n";
    std::string text = fmt::format("{:<8} {:<34} {:<34}\n", "", "side actions of A, travel", "of B, travel");
    for (std::size_t k = 0; k < std::min(comparison_.actions.size(), k_most_rows); ++k) {
      const MatchedChange& change = comparison_.actions[k];
      const auto action = [&](const std::vector<SideAction>& all, const std::optional<std::size_t>& number) {
        if (!number) return std::string("-");
        const SideAction& one = all[*number];
        return fmt::format("{} {} {}", facts(one.kind).name, short_direction_text(one.direction),
                           lengths_.text(one.travel));
      };
      text += fmt::format("{:<8} {:<34} {}\n", change_name(change.kind), action(before, change.former),
                          action(after, change.fresh));
    }
    return text + more_text(comparison_.actions.size());
  }

 private:
  const Comparison& comparison_;
  std::string area_unit_;
  FigureColumn areas_, lengths_;
};

}  // namespace

nlohmann::ordered_json compare_json(const Comparison& comparison) {
  const auto& [a, b, settings, alignment, surface, undercuts, actions, remarks] = comparison;
  Json json;
  json["schema"] = "moldlight.compare/1";
  json["a"] = part_json(*a.model, a.result.warnings);
  json["b"] = part_json(*b.model, b.result.warnings);
  json["direction"] = {{"a", vector_json(a.result.direction)}, {"b", vector_json(b.result.direction)}};
  json["settings"] = options_json(method_options(), a.result.settings);
  json["settings"].update(options_json(compare_options(), settings));
  json["settings"].update(options_json(action_options(), settings.actions));
  json["same_within"] = surface.tolerance.apart;
  json["tessellation"] = surface.chords;
  json["alignment"] = alignment ? alignment_json(*alignment) : Json();
  json["surface"] = {{"gone", area_json(surface.gone)}, {"new", area_json(surface.fresh)}};
  json["places"] = places_json(comparison);
  const Json areas_a = areas_json(a.result), areas_b = areas_json(b.result);
  json["regions"] = {{"a", areas_a},
                     {"b", areas_b},
                     {"difference", difference_json(areas_a, areas_b)},
                     {"changed", changed_regions_json(surface)}};
  json["undercuts"] = nullptr;
  json["actions"] = nullptr;
  if (a.plan && b.plan) {
    json["undercuts"] = changes_json(undercuts, a.plan->patches, b.plan->patches, undercut_json);
    json["actions"] = changes_json(actions, a.plan->actions, b.plan->actions, action_json);
  }
  json["remarks"] = remarks;
  json["verdict"] = comparison_verdict(comparison);
  return json;
}

std::string compare_table(const Comparison& comparison) {
  const Table table(comparison);
  std::string text = table.heading() + "\n" + comparison_verdict(comparison) + "\n";
  for (const std::string& remark : comparison.remarks) text += remark + ".\n";
  text += "\n" + table.places() + "\n" + table.regions();
  const std::string changed = table.changed_regions();
  if (!changed.empty()) text += "\n" + changed;
  if (comparison.a.plan && comparison.b.plan) text += "\n" + table.undercuts() + "\n" + table.actions();
  return text;
}

}  // namespace moldlight
