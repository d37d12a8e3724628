#include "actions/actions_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "actions/action_figures.hpp"
#include "actions/action_words.hpp"
#include "actions/best_changes.hpp"
#include "classify/classify_report.hpp"
#include "classify/figure_table.hpp"
#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"
#include "mesh/place_order.hpp"

namespace moldlight {

namespace {

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
  for (const FacetIndex facet : facets) list.push_back(file_facet(part, facet));
  return list;
}

Json window_json(const Part& part, const UndercutWindow& window) {
  Json polygon = Json::array();
  for (const std::vector<glm::dvec3>& loop : window.loops) {
    Json points = Json::array();
    for (const glm::dvec3& point : loop) points.push_back(point_json(point));
    polygon.push_back(std::move(points));
  }
  return {{"side", side_name(window.core_side)},
          {"area", window.area},
          {"polygon", polygon},
          {"through",
           {{"facets", facets_json(part, window.through)},
            {"place", point_json(window.place)},
            {"thickness", {window.least_thickness, window.thickness}}}}};
}

Json change_json(const Part& part, const DesignChange& change) {
  return {{"depth", change.depth ? Json(*change.depth) : Json()},
          {"direction", point_json(change.direction)},
          {"window", change.window ? window_json(part, *change.window) : Json()}};
}

Json undercut_json(const Part& part, const UndercutReport& noted, std::size_t number) {
  Json json = {{"id", number},
               {"centre", point_json(noted.undercut.centre)},
               {"side", side_name(noted.core_side)},
               {"blocked_by", facets_json(part, noted.blocked_by)},
               {"point", point_json(noted.point)},
               {"pinned", noted.pin ? Json(pin_name(*noted.pin)) : Json()},
               {"closed_void", noted.closed_void}};
  put_figures(found_figures(undercut_sizes(), noted.undercut), json);
  put_figures(found_figures(undercut_figures(), noted), json);
  return json;
}

/// True where nothing is hit.
Json hit_json(const std::optional<BodyHit>& hit) {
  if (!hit) return true;
  return {{"hits", hit->action ? Json(*hit->action + 1) : Json("part")},
          {"depth", hit->depth},
          {"place", point_json(hit->place)},
          {"when", stage_text(hit->stage)}};
}

Json action_json(const SideAction& action) {
  Json axis;
  if (action.about)
    axis = {{"point", point_json(action.about->point)}, {"direction", point_json(action.about->direction)}};
  Json json = {{"kind", facts(action.kind).name},
               {"feature", action.feature},
               {"sequence", sequence_of(action.kind)},
               {"direction", point_json(action.direction)},
               {"interval_deg", {action.interval.from_deg, action.interval.to_deg}},
               {"axis", axis},
               {"undercuts", numbers_json(action.undercuts)},
               {"side", side_name(action.core_side)},
               {"meets", numbers_json(action.meets)},
               {"body", {{"file", Json()}}},
               {"clear", action.body ? hit_json(action.body->hit) : Json()}};
  put_figures(found_figures(action_figures(), action), json);
  put_figures(found_figures(body_figures(), action), json);
  return json;
}

/// Each with what would have to be done to its undercuts, where that was looked for.
Json saving_json(const SavingChange& change, const ActionsReport& report) {
  Json todo = Json::array();
  for (const std::size_t undercut : change.undercuts) {
    if (undercut < report.changes.size()) todo.push_back(change_text(report, undercut));
  }
  return {{"undercuts", numbers_json(change.undercuts)},
          {"actions", numbers_json(change.actions)},
          {"saves", change.saves},
          {"to_be_free", todo}};
}

Json rejected_json(const RejectedAction& rejected) {
  return {{"undercut", rejected.undercut + 1},
          {"kind", facts(rejected.kind).name},
          {"direction", point_json(rejected.direction)},
          {"travel", rejected.travel},
          {"side", side_name(rejected.core_side)},
          {"reason", reject_text(rejected.reason)},
          {"place", point_json(rejected.place)},
          {"room", std::isfinite(rejected.room) ? Json(rejected.room) : Json()},
          {"depth", rejected.depth > 0.0 ? Json(rejected.depth) : Json()},
          {"when", rejected.depth > 0.0 && rejected.strain == 0.0 ? Json(stage_text(rejected.when)) : Json()},
          {"width", rejected.width > 0.0 ? Json(rejected.width) : Json()},
          {"lean_deg", rejected.lean_deg > 0.0 ? Json(rejected.lean_deg) : Json()},
          {"strain", rejected.strain > 0.0 ? Json(rejected.strain) : Json()},
          {"left", rejected.left > 0.0 ? Json(rejected.left) : Json()}};
}

/// Without the sign of what two decimals show as 0.
double unsigned_zero(double value) { return std::abs(value) < 5e-3 ? 0.0 : value; }

}  // namespace

std::string undercut_items(const PartModel& model, const ActionPlan& plan, std::size_t undercut) {
  const UndercutReport& found = plan.undercuts[undercut];
  const FigureStyle style(model);
  std::string text = style.with_unit(FigureKind::area, found.undercut.area);
  if (found.depth) text += " · depth " + style.with_unit(FigureKind::length, *found.depth);
  const SideAction* const action = action_of(plan, undercut);
  if (action == nullptr) return text;
  if (std::ranges::find(plan.unreleased, undercut) != plan.unreleased.end()) text += " · partly released";
  return text + fmt::format(" · travel {} · {}{}{}", style.with_unit(FigureKind::length, action->travel),
                            detail_text(*action, length_unit(model.part)), shared_text(*action, undercut),
                            others_text(plan, undercut, *action));
}

std::string undercut_details(const PartModel& model, const ActionPlan& plan, std::size_t undercut) {
  const SideAction* const action = action_of(plan, undercut);
  if (action == nullptr) return {};
  const FigureStyle style(model);
  const std::string unit = length_unit(model.part);
  std::string text = fmt::format(
      "{} along {}\ntravel {:.2f} {} · {}{}", facts(action->kind).singular,
      with_minus(direction_words(action->direction)), action->travel, unit, detail_text(*action, unit),
      shared_text(*action, undercut) + others_text(plan, undercut, *action) + meets_text(plan, *action));
  for (const FoundFigure& figure : found_figures(body_figures(), *action))
    if (figure.value && !figure.title.empty())
      text += fmt::format("{}{} {}", figure.key == body_figures().front().key ? "\n" : " · ", figure.title,
                          style.with_unit(figure.kind, *figure.value));
  return action->body ? text + " · " + clear_text(*action, plan, unit) : text;
}

std::string change_text(const ActionsReport& report, std::size_t undercut, bool with_places) {
  const PartModel& model = report.model;
  const std::string unit = length_unit(model.part);
  std::vector<std::string> ways;
  const auto refused = std::ranges::find(report.plan.rejected, undercut, &RejectedAction::undercut);
  if (refused != report.plan.rejected.end() && refused->reason == RejectReason::no_room)
    ways.push_back(fmt::format(
        "widen the mouth from {} to {} {}, for a lifter", rounded(refused->travel + refused->room),
        rounded(refused->travel + report.settings.lifter_room_mm * unit_per_mm(model.part)), unit));
  if (refused != report.plan.rejected.end() && refused->reason == RejectReason::thin_pin)
    ways.push_back(fmt::format("widen the hole from {} to {} {}", rounded(refused->width),
                               rounded(report.settings.pin_diameter_mm * unit_per_mm(model.part)), unit));
  if (refused != report.plan.rejected.end() && refused->reason == RejectReason::too_strained) {
    const double share = 0.01 * report.settings.strip_strain_pct / refused->strain;
    ways.push_back(fmt::format("make the ring {} instead of {} {} deep, to strip it off",
                               rounded(share * refused->depth), rounded(refused->depth), unit));
  }
  const DesignChange& change = report.changes[undercut];
  if (report.plan.undercuts[undercut].closed_void) ways.emplace_back("fill the void");
  if (change.depth) ways.push_back(fmt::format("cut back by {} {}", rounded(*change.depth), unit));
  if (const auto& window = change.window) {
    const FigureStyle style(model);
    const std::string least = rounded(window->least_thickness), greatest = rounded(window->thickness);
    ways.push_back(fmt::format("open a window of {} towards the {}{}, through {}{} {} of wall",
                               style.with_unit(FigureKind::area, window->area), side_name(window->core_side),
                               with_places ? " at " + style.point(window->place) : "",
                               least == greatest ? "" : least + " to ", greatest, unit));
  }
  return ways.empty() ? "-" : fmt::format("{}", fmt::join(ways, ", or "));
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
  const std::string_view who = slides == number ? "slides" : slides == 0 ? "lifters" : "slides and lifters";
  return fmt::format("The paths of {} cross{}: rows {}{}.", who,
                     plan.optimal ? ", and no alternative was found" : "", pairs,
                     number > k_most ? fmt::format(" … {} pairs in all", number) : "");
}

std::string pins_notice(const PartModel& model, const ActionPlan& plan) {
  std::string text;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const std::optional<CorePin>& pin = plan.actions[k].core_pin;
    if (!pin || pin->length <= k_slender_pin * pin->width) continue;
    text += fmt::format("{}A core pin of {} is {} {} long and {} {} thick: it may bend.",
                        text.empty() ? "" : " ", action_title(plan, k), rounded(pin->length),
                        length_unit(model.part), rounded(pin->width), length_unit(model.part));
  }
  return text;
}

std::string numbers_text(const std::vector<std::size_t>& numbers) {
  constexpr std::size_t k_most = 12;
  std::string text;
  for (std::size_t k = 0; k < std::min(numbers.size(), k_most); ++k)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", numbers[k] + 1);
  return numbers.size() > k_most ? fmt::format("{}, … {} in all", text, numbers.size()) : text;
}

std::string rejected_text(const PartModel& model, const ActionPlan& plan) {
  constexpr std::size_t k_most = 6;
  const FigureStyle style(model);
  const std::string unit = length_unit(model.part);
  const auto why = [&](const RejectedAction& rejected) {
    switch (rejected.reason) {
      case RejectReason::no_room:
        return fmt::format("it travels {0} {2} and has {1} {2} of room beyond that", rounded(rejected.travel),
                           rounded(rejected.room), unit);
      case RejectReason::no_way_out:
        return fmt::format("it travels {} {} and then cannot leave along its half", rounded(rejected.travel),
                           unit);
      case RejectReason::no_stem:
        return std::string("there is no room for its stem down to the ejector plate");
      case RejectReason::too_far:
        return fmt::format("it would have to travel {} {}, farther than ejectors drive it",
                           rounded(rejected.travel), unit);
      case RejectReason::thin_pin:
        return fmt::format("its core pin of {} {} is too thin", rounded(rejected.width), unit);
      case RejectReason::too_strained:
        return fmt::format("the part would stretch by {} %, more than --strip-strain permits",
                           rounded(100.0 * rejected.strain));
      case RejectReason::too_steep:
        return fmt::format("it leans {:.1f}° off the plane across the direction, more than --incline permits",
                           rejected.lean_deg);
      case RejectReason::leaves_rest:
        return fmt::format("it leaves {} unreleased", style.with_unit(FigureKind::area, rejected.left));
      default:
        return fmt::format("its body reaches {} {} into {} {}", rounded(rejected.depth), unit,
                           rejected.reason == RejectReason::hits_part ? "the part" : "another action",
                           stage_text(rejected.when));
    }
  };
  struct Refused {
    std::string kind, why;
    std::vector<std::size_t> undercuts;
  };
  std::vector<Refused> all;
  for (const RejectedAction& rejected : plan.rejected) {
    Refused one{std::string(facts(rejected.kind).singular), why(rejected), {}};
    auto same = std::ranges::find_if(
        all, [&](const Refused& other) { return other.kind == one.kind && other.why == one.why; });
    if (same == all.end()) same = all.insert(all.end(), std::move(one));
    if (std::ranges::find(same->undercuts, rejected.undercut) == same->undercuts.end())
      same->undercuts.push_back(rejected.undercut);
  }
  std::string refused;
  for (const Refused& one : std::span(all).first(std::min(all.size(), k_most)))
    refused += fmt::format("{}{} for undercut{} {} ({})", refused.empty() ? "Refused: " : "; ", one.kind,
                           one.undercuts.size() == 1 ? "" : "s", numbers_text(one.undercuts), one.why);
  if (all.size() > k_most) refused += fmt::format("; {} more", all.size() - k_most);
  return refused.empty() ? refused : refused + ".";
}

std::string clear_text(const SideAction& action, const ActionPlan& plan, const std::string& unit) {
  if (!action.body) return "-";
  const auto& hit = action.body->hit;
  if (!hit) return "clear";
  return fmt::format("{} {} deep in {} {}", rounded(hit->depth), unit,
                     hit->action ? action_title(plan, *hit->action) : "the part", stage_text(hit->stage));
}

namespace {

/// Undercuts were "patches" once, and lifters without their room were actions; scripts that ask for these
/// find them until the schema's number rises.
void add_former_names(Json& json) {
  const auto add = [](Json& owner) { owner["patches"] = owner["undercuts"]; };
  add(json);
  add(json["unreleased"]);
  for (const char* const list : {"actions", "changes"})
    for (Json& one : json[list]) add(one);
  for (Json& one : json["rejected"]) one["patch"] = one["undercut"];
  for (Json& one : json["actions"]) {
    one["has_room"] = true;
    one["lack"] = nullptr;
  }
}

}  // namespace

nlohmann::ordered_json actions_json(const ActionsReport& report) {
  const auto& [model, result, settings, plan, changes] = report;
  Json json;
  json["schema"] = "moldlight.actions/2";
  json["part"] = part_json(model, result.warnings);
  json["direction"] = point_json(result.direction);
  json["settings"] = options_json(method_options(), result.settings);
  json["settings"].update(options_json(action_options(), settings));
  json["undercuts"] = Json::array();
  for (std::size_t k = 0; k < plan.undercuts.size(); ++k) {
    json["undercuts"].push_back(undercut_json(model.part, plan.undercuts[k], k + 1));
    json["undercuts"].back()["to_be_free"] =
        k < changes.size() ? change_json(model.part, changes[k]) : Json();
  }
  json["actions"] = Json::array();
  for (const SideAction& action : plan.actions) json["actions"].push_back(action_json(action));
  json["rejected"] = Json::array();
  for (const RejectedAction& rejected : plan.rejected) json["rejected"].push_back(rejected_json(rejected));
  json["changes"] = Json::array();
  for (const SavingChange& change : best_changes(plan, settings.prices))
    json["changes"].push_back(saving_json(change, report));
  json["unreleased"] = {{"area", plan.unreleased_area}, {"undercuts", numbers_json(plan.unreleased)}};
  json["dropped"] = {{"number", speck_count(plan)}, {"area", speck_area(plan)}};
  json["specks"] = Json::array();
  for (const Speck& speck : plan.specks)
    json["specks"].push_back(
        {{"area", speck.area}, {"place", point_json(speck.place)}, {"reason", speck_text(speck.reason)}});
  json["optimal"] = plan.optimal;
  add_former_names(json);
  return json;
}

std::string actions_csv(const ActionsReport& report) {
  std::string text =
      "undercut,area,formed_area,x,y,z,size_across,size_along,depth,side,kind,dx,dy,dz,travel\n";
  const auto out = std::back_inserter(text);
  for (std::size_t k = 0; k < report.plan.undercuts.size(); ++k) {
    const UndercutReport& noted = report.plan.undercuts[k];
    const Undercut& undercut = noted.undercut;
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{}", k + 1, undercut.area, noted.formed_area,
                   undercut.centre.x, undercut.centre.y, undercut.centre.z, undercut.size_across,
                   undercut.size_along, noted.depth ? real_text(*noted.depth) : "",
                   side_name(noted.core_side));
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
