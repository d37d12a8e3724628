#include "actions/actions_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/figures.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

std::string_view side_name(bool core_side) { return region_name(core_side ? Region::core : Region::cavity); }

/// Counted from 1.
Json numbers_json(const std::vector<std::size_t>& numbers) {
  Json list = Json::array();
  for (const std::size_t number : numbers) list.push_back(number + 1);
  return list;
}

/// Facets as the file numbers them.
Json facets_json(const Part& part, const std::vector<FacetIndex>& facets) {
  Json list = Json::array();
  for (const FacetIndex facet : facets)
    list.push_back(part.file_facets.empty() ? facet : part.file_facets[facet]);
  return list;
}

Json window_json(const Part& part, const UndercutWindow& window) {
  Json polygon = Json::array();
  for (const std::vector<glm::dvec3>& loop : window.loops) {
    Json points = Json::array();
    for (const glm::dvec3& point : loop) points.push_back(vector_json(point));
    polygon.push_back(std::move(points));
  }
  return {{"side", side_name(window.core_side)},
          {"area", window.area},
          {"polygon", polygon},
          {"through",
           {{"facets", facets_json(part, window.through)},
            {"place", vector_json(window.place)},
            {"thickness", {window.least_thickness, window.thickness}}}}};
}

Json change_json(const Part& part, const ToBeFree& change) {
  return {{"depth", change.depth ? Json(*change.depth) : Json()},
          {"direction", change.direction ? vector_json(*change.direction) : Json()},
          {"window", change.window ? window_json(part, *change.window) : Json()}};
}

Json patch_json(const Part& part, const UndercutReport& patch, std::size_t number) {
  return {{"id", number},
          {"area", patch.undercut.area},
          {"formed_area", patch.formed_area},
          {"centre", vector_json(patch.undercut.centre)},
          {"size_across", patch.undercut.size_across},
          {"size_along", patch.undercut.size_along},
          {"depth", finite(patch.depth)},
          {"side", side_name(patch.core_side)},
          {"blocked_by", facets_json(part, patch.blocked_by)},
          {"point", vector_json(patch.point)},
          {"pinned", patch.pin ? Json(pin_name(*patch.pin)) : Json()}};
}

Json action_json(const SideAction& action) {
  const bool thread = action.kind == ActionKind::unscrew;
  Json axis;
  if (action.about)
    axis = {{"point", vector_json(action.about->point)}, {"direction", vector_json(action.about->direction)}};
  return {{"kind", facts(action.kind).name},
          {"direction", vector_json(action.direction)},
          {"interval_deg", {action.interval.from_deg, action.interval.to_deg}},
          {"travel", action.travel},
          {"stroke", action.stroke ? Json(*action.stroke) : Json()},
          {"axis", axis},
          {"pitch", thread ? Json(action.about->pitch) : Json()},
          {"turns", thread ? Json(action.about->turns) : Json()},
          {"strain", action.kind == ActionKind::strip ? Json(action.about->strain) : Json()},
          {"patches", numbers_json(action.patches)},
          {"area", action.area},
          {"side", side_name(action.core_side)},
          {"clear_to", finite(action.clear_to)},
          {"room_needed", action.kind == ActionKind::lifter ? Json(action.room_needed) : Json()},
          {"has_room", has_room(action)},
          {"meets", numbers_json(action.meets)}};
}

std::string patches_text(const std::vector<std::size_t>& patches) {
  constexpr std::size_t k_most = 6;
  std::string text;
  for (std::size_t k = 0; k < std::min(patches.size(), k_most); ++k)
    text += fmt::format("{}{}", k == 0 ? "" : " ", patches[k] + 1);
  return patches.size() > k_most ? fmt::format("{} … {} in all", text, patches.size()) : text;
}

/// Without the sign of what two decimals show as 0.
double unsigned_zero(double value) { return std::abs(value) < 5e-3 ? 0.0 : value; }

std::string changes_text(std::span<const ToBeFree> changes, const std::string& unit,
                         const std::string& area_unit) {
  constexpr std::size_t k_most = 6;
  if (changes.empty()) return "";
  std::string text = "\nWithout side actions, what reaches over an undercut would have to be\n";
  for (std::size_t k = 0; k < std::min(changes.size(), k_most); ++k)
    text += fmt::format("{:>4}  {}\n", k + 1, change_text(changes[k], unit, area_unit));
  if (changes.size() > k_most) text += fmt::format("   …  {} in all\n", changes.size());
  return text;
}

}  // namespace

std::string change_text(const ToBeFree& change, const std::string& unit, const std::string& area_unit) {
  std::string text;
  if (change.depth) text = fmt::format("cut back by {:.4g} {}", *change.depth, unit);
  if (const auto& window = change.window) {
    const std::string least = fmt::format("{:.3g}", window->least_thickness);
    const std::string greatest = fmt::format("{:.3g}", window->thickness);
    text += fmt::format("{}opened towards {} by a window of {} {} through {}{} {}",
                        text.empty() ? "" : ", or ", side_name(window->core_side), figure(window->area),
                        area_unit, least == greatest ? "" : least + " to ", greatest, unit);
  }
  return text.empty() ? "-" : text;
}

std::string freedom_text(const SideAction& action, const std::string& unit) {
  switch (action.kind) {
    case ActionKind::unscrew:
      return fmt::format("pitch {:.3f} {}", action.about->pitch, unit);
    case ActionKind::strip:
      return fmt::format("strain {:.2f} %", 100.0 * action.about->strain);
    case ActionKind::insert:
      return "by hand";
    default:
      return fmt::format("{:.2f} to {:.2f}°", unsigned_zero(action.interval.from_deg),
                         action.interval.to_deg);
  }
}

std::string meetings_text(const ActionPlan& plan) {
  constexpr std::size_t k_most = 6;
  std::string pairs;
  std::size_t number = 0, slides = 0;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    for (const std::size_t other : plan.actions[k].meets) {
      if (other < k) continue;
      slides += is_slide(plan.actions[k].kind) ? 1 : 0;
      if (++number <= k_most) pairs += fmt::format("{}{} and {}", number == 1 ? "" : ", ", k + 1, other + 1);
    }
  }
  if (number == 0) return "";
  const std::string_view who = slides == number ? "Slides" : slides == 0 ? "Lifters" : "Slides and lifters";
  return fmt::format("\n{} would meet, since their ways cross{}: rows {}{}.\n", who,
                     plan.optimal ? ", and nothing that was tried avoids it" : "", pairs,
                     number > k_most ? fmt::format(" … {} pairs in all", number) : "");
}

std::string crowded_text(const ActionPlan& plan, const std::string& unit) {
  constexpr std::size_t k_most = 6;
  std::string rows;
  std::size_t number = 0;
  double needed = 0.0;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    if (has_room(action) || ++number > k_most) continue;
    needed = action.room_needed;
    rows += fmt::format("{}{} ({:.2f} {})", number == 1 ? "" : ", ", k + 1, action.clear_to - action.travel,
                        unit);
  }
  if (number == 0) return "";
  return fmt::format("\nLifters with less room beyond their travel than {:.3g} {}: rows {}{}.\n", needed,
                     unit, rows, number > k_most ? fmt::format(" … {} in all", number) : "");
}

nlohmann::ordered_json actions_json(const ActionsReport& report) {
  const auto& [model, result, settings, plan, changes] = report;
  Json json;
  json["schema"] = "moldlight.actions/1";
  json["part"] = part_json(model, result.warnings);
  json["direction"] = vector_json(result.direction);
  json["settings"] = options_json(method_options(), result.settings);
  json["settings"].update(options_json(action_options(), settings));
  json["patches"] = Json::array();
  for (std::size_t k = 0; k < plan.patches.size(); ++k) {
    json["patches"].push_back(patch_json(model.part, plan.patches[k], k + 1));
    json["patches"].back()["to_be_free"] = k < changes.size() ? change_json(model.part, changes[k]) : Json();
  }
  json["actions"] = Json::array();
  for (const SideAction& action : plan.actions) json["actions"].push_back(action_json(action));
  json["unreleased"] = {{"area", plan.unreleased_area}, {"patches", numbers_json(plan.unreleased)}};
  json["dropped"] = {{"number", plan.dropped}, {"area", plan.dropped_area}};
  json["optimal"] = plan.optimal;
  return json;
}

std::string actions_table(const ActionsReport& report) {
  const auto& [model, result, settings, plan, changes] = report;
  const std::string unit = length_unit(model.part), area_unit = powered_unit(model.part, 2);
  const FigureColumn areas(result.total_area), lengths(10.0 * model.frame.diagonal);
  std::string text = fmt::format("{}: {} undercut{} along {}, {} {} ({})\n", part_name(model.part),
                                 plan.patches.size(), plan.patches.size() == 1 ? "" : "s",
                                 figures(result.direction, 1.0), areas.text(result.areas[Region::undercut]),
                                 area_unit, share_text(result.areas[Region::undercut], result.total_area));
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "side actions: {}\n", actions_text(plan));
  if (!plan.actions.empty()) {
    fmt::format_to(out, "\n{:<9} {:>22} {:>17} {:>11} {:>11} {:>11}  undercuts\n", "kind", "direction",
                   "free to turn", "travel " + unit, "stroke " + unit, "area " + area_unit);
    for (const SideAction& action : plan.actions) {
      fmt::format_to(out, "{:<9} {:>22} {:>17} {:>11} {:>11} {:>11}  {}\n", facts(action.kind).name,
                     direction_text(action.direction, 3), freedom_text(action, unit),
                     lengths.text(action.travel), action.stroke ? lengths.text(*action.stroke) : "",
                     areas.text(action.area), patches_text(action.patches));
    }
    text += meetings_text(plan) + crowded_text(plan, unit);
  }
  if (!plan.unreleased.empty())
    fmt::format_to(out, "\nNothing that was tried releases {} {} in {} undercuts: {}\n",
                   areas.text(plan.unreleased_area), area_unit, plan.unreleased.size(),
                   patches_text(plan.unreleased));
  for (const std::size_t patch : plan.unreleased) {
    if (plan.patches[patch].pin)
      fmt::format_to(out, "undercut {}: {}\n", patch + 1, unreleased_text(plan, patch));
  }
  if (plan.dropped > 0)
    fmt::format_to(out, "{} patches within the lateral tolerance are left out, {} {}.\n", plan.dropped,
                   figure(plan.dropped_area), area_unit);
  text += plan.optimal ? "No cheaper set of the actions that were tried releases as much.\n"
                       : "A cheaper set may exist: the search for the least was given up.\n";
  text += changes_text(changes, unit, area_unit);
  return text;
}

std::string actions_csv(const ActionsReport& report) {
  std::string text = "patch,area,formed_area,x,y,z,size_across,size_along,depth,side,kind,dx,dy,dz,travel\n";
  const auto out = std::back_inserter(text);
  for (std::size_t k = 0; k < report.plan.patches.size(); ++k) {
    const UndercutReport& patch = report.plan.patches[k];
    const Undercut& undercut = patch.undercut;
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{}", k + 1, undercut.area, patch.formed_area,
                   undercut.centre.x, undercut.centre.y, undercut.centre.z, undercut.size_across,
                   undercut.size_along, patch.depth, side_name(patch.core_side));
    if (const SideAction* action = action_of(report.plan, k)) {
      fmt::format_to(out, ",{},{},{},{},{}\n", facts(action->kind).name, action->direction.x,
                     action->direction.y, action->direction.z, action->travel);
    } else {
      text += ",none,,,,\n";
    }
  }
  return text;
}

}  // namespace moldlight
