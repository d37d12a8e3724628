#include "parting/mold_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/classify_report.hpp"
#include "classify/figures.hpp"
#include "classify/method_options.hpp"
#include "classify/option_table.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

Json point_json(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Json loop_json(const PartingLoop& loop) {
  Json points = Json::array();
  for (const glm::dvec3& point : loop.points) points.push_back(point_json(point));
  return {{"kind", loop_name(loop.kind)},
          {"length", loop.length},
          {"climb", loop.climb()},
          {"low", loop.low},
          {"high", loop.high},
          {"up_and_down", loop.up_and_down},
          {"flatness", loop.flatness},
          {"steep_length", loop.steep_length},
          {"steep_draft_deg", loop.steep_draft_deg},
          {"steepest_deg", loop.steepest_deg},
          {"sharpest_deg", loop.sharpest_deg},
          {"on_crease", loop.on_crease},
          {"projected_area", loop.area},
          {"breaks", loop.breaks},
          {"break_length", loop.break_length},
          {"smoothed",
           {{"points", loop.moved}, {"length", loop.smoothed_length}, {"climb", loop.smoothed_climb}}},
          {"points", points}};
}

/// A number of each side.
template <typename Value>
Json of_sides(const Value& value) {
  Json json;
  for (const MoldSide side : k_mold_sides) json[std::string(side_name(side))] = value(side);
  return json;
}

Json euler_json(const EulerCheck& euler) {
  return {{"part", euler.part},
          {"core", euler.core},
          {"cavity", euler.cavity},
          {"action", euler.action},
          {"touching", euler.touching},
          {"sums", euler.sums()},
          {"bodies", euler.bodies},
          {"core_pieces", euler.core_pieces},
          {"cavity_pieces", euler.cavity_pieces},
          {"action_pieces", euler.action_pieces},
          {"borders", of_sides([&](MoldSide side) { return euler.borders[static_cast<std::size_t>(side)]; })},
          {"handles", of_sides([&](MoldSide side) { return euler.twice_handles(side) / 2; })},
          {"accounted", euler.accounted()},
          {"loops", euler.loops},
          {"expected_loops", euler.expected_loops},
          {"genus", euler.genus}};
}

Json body_json(const WrittenBody& body) {
  return {{"file", body.file.empty() ? Json() : Json(body.file)},
          {"volume", body.volume},
          {"closed", body.closed},
          {"crowded_edges", body.crowded_edges}};
}

Json half_json(const WrittenBody& written, const MoldBody& body) {
  Json json = body_json(written);
  json["undercut"] = written.undercut;
  json["crossed_facets"] = body.crossed_facets;
  json["crossed_at"] = body.crossed_at ? point_json(*body.crossed_at) : Json();
  json["needles"] = body.needles;
  json["needle_at"] = body.needle_at ? point_json(*body.needle_at) : Json();
  return json;
}

Json contacts_json(const MoldHalves& halves) {
  Json list = Json::array();
  for (const ContactWall& wall : halves.contacts)
    list.push_back({{"place", point_json(wall.place)}, {"height", wall.height}, {"area", wall.area}});
  return list;
}

Json missed_json(const MissedFaces& missed) {
  return {{"area", missed.area}, {"place", missed.at ? point_json(*missed.at) : Json()}};
}

/// The loop at which the halves were refused.
std::string refused_loop(const MoldReport& report) {
  const auto& place = report.halves.refused_at;
  return place ? loop_near(report.line, *place) : std::string();
}

Json refusal_json(const MoldReport& report) {
  const MoldHalves& halves = report.halves;
  if (report.written.refusal.empty()) return {};
  const std::string loop = refused_loop(report);
  return {{"why", report.written.refusal},
          {"place", halves.refused_at ? point_json(*halves.refused_at) : Json()},
          {"loop", loop.empty() ? Json() : Json(loop)},
          {"change", halves.change}};
}

void add_actions(const ActionPlan& plan, const InsertActions& of_insert, Json& json) {
  json["actions"] = Json::array();
  for (const std::size_t number : of_insert.actions) {
    const SideAction& action = plan.actions[number];
    json["actions"].push_back({{"kind", facts(action.kind).name},
                               {"direction", point_json(action.direction)},
                               {"travel", action.travel}});
  }
  json["unreleased"] = of_insert.unreleased;
}

/// "2 are formed by side actions: insert_1 by a slide along …".
std::string insert_actions_text(const MoldReport& report) {
  std::string text;
  for (std::size_t k = 0; k < report.by_action.size(); ++k) {
    for (const std::size_t number : report.by_action[k].actions) {
      const SideAction& action = report.plan->actions[number];
      text += fmt::format("          insert_{} goes with a {} along {}{}\n", k + 1, facts(action.kind).name,
                          direction_text(action.direction, 3),
                          report.by_action[k].unreleased > 0 ? ", but not all of it" : "");
    }
  }
  return text;
}

/// How a toolmaker cuts the surface around the part: its plane, what leads from there to the line, and how
/// much the block's edge rises.
Json surface_json(const MoldReport& report) {
  const SurfaceFigures& surface = report.halves.surface;
  return {{"shelf", {{"height", surface.shelf_height}, {"share", surface.shelf_share()}}},
          {"ramps", surface.ramp_area},
          {"land", land_width(report.settings, report.model.frame.diagonal)},
          {"rise", surface.high - surface.low},
          {"rim_range", surface.rim_high - surface.rim_low},
          {"faces", surface.faces},
          {"margin", report.halves.margin}};
}

/// Halves, surfaces, inserts; null where there are none.
void add_halves(const MoldReport& report, Json& json) {
  const MoldHalves& halves = report.halves;
  const WrittenMold& written = report.written;
  const bool made = halves.made();
  json["surfaces"] = made ? Json{{"parting", halves.surface.parting_area},
                                 {"shut_offs", halves.surface.shut_off_area},
                                 {"steepest_deg", halves.surface.steepest_deg},
                                 {"too_steep", halves.surface.too_steep_area},
                                 {"contact", halves.contact_area},
                                 {"contacts", contacts_json(halves)},
                                 {"forced_deg", halves.forced_deg},
                                 {"forced_at", halves.forced_at ? point_json(*halves.forced_at) : Json()}}
                          : Json();
  json["surface"] = made ? surface_json(report) : Json();
  json["halves"] = Json();
  json["inserts"] = Json::array();
  json["volume_gap"] = made ? Json(halves.volume_gap) : Json();
  json["refused"] = refusal_json(report);
  if (!made || written.bodies.size() < 2) return;
  json["halves"] = {
      {"core", half_json(written.bodies[0], halves.core)},
      {"cavity", half_json(written.bodies[1], halves.cavity)},
      {"frame", written.part_frame ? "part" : "mold"},
      {"scale", halves.scale},
      {"block_volume", halves.block_volume},
      {"part_volume", halves.part_volume},
      {"insert_volume", halves.insert_volume},
      {"specks_volume", halves.specks_volume},
      {"missed",
       {{"leaning", missed_json(halves.missed_leaning)}, {"upright", missed_json(halves.missed_upright)}}}};
  for (std::size_t k = 0; k + 2 < written.bodies.size(); ++k) {
    Json insert = body_json(written.bodies[k + 2]);
    insert["place"] = point_json(insert_place(halves, k));
    if (report.plan != nullptr) add_actions(*report.plan, report.by_action[k], insert);
    json["inserts"].push_back(std::move(insert));
  }
}

std::string halves_table(const MoldReport& report) {
  const MoldHalves& halves = report.halves;
  const WrittenMold& written = report.written;
  const Part& part = report.model.part;
  if (!written.refusal.empty())
    return "\n" + refusal_text(report.model, halves, written, refused_loop(report)) + "\n";
  const std::string area_unit = powered_unit(part, 2), volume_unit = powered_unit(part, 3);
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out,
      "\nhalves    core {} {}, cavity {}, closed; volumes with part and inserts are {} of the block apart\n",
      figure(halves.core.volume), volume_unit, figure(halves.cavity.volume),
      error_text(std::abs(halves.volume_gap)));
  fmt::format_to(out, "          parting surface {} {}, shut-offs {}; no steeper than {:.0f}°{}\n",
                 figure(halves.surface.parting_area), area_unit, figure(halves.surface.shut_off_area),
                 std::ceil(std::min(halves.surface.steepest_deg, report.settings.slope_deg) - 1e-6),
                 halves.surface.too_steep_area > 0.0
                     ? fmt::format(" but for {} {}, up to {:.0f}°", error_text(halves.surface.too_steep_area),
                                   area_unit, std::ceil(halves.surface.steepest_deg))
                     : "");
  if (!halves.contacts.empty()) {
    const ContactWall& most = halves.contacts.front();
    fmt::format_to(out,
                   "          steel on steel without draft: {} {} in {} place{}, the most at {}, {} high\n",
                   figure(halves.contact_area), area_unit, halves.contacts.size(),
                   halves.contacts.size() == 1 ? "" : "s", figures(most.place, 1.0), figure(most.height));
  }
  if (halves.forced_at) {
    fmt::format_to(out, "          the part's own outline {}, near {}: no parting surface meets all of it\n",
                   halves.forced_deg > 89.99 ? std::string("has steps")
                                             : fmt::format("is up to {:.1f}° steep", halves.forced_deg),
                   figures(*halves.forced_at, report.model.frame.diagonal));
  }
  for (const std::string& line : missed_lines(report.model, halves))
    fmt::format_to(out, "          {}\n", line);
  if (!halves.inserts.empty()) {
    fmt::format_to(out, "          left to {} insert{}: {} {}, {} of the part's volume\n",
                   halves.inserts.size(), halves.inserts.size() == 1 ? "" : "s", figure(halves.insert_volume),
                   volume_unit, share_text(halves.insert_volume, halves.part_volume));
  }
  if (report.plan != nullptr) text += insert_actions_text(report);
  const std::size_t crossed = halves.core.crossed_facets + halves.cavity.crossed_facets,
                    touching = halves.core.crowded_edges + halves.cavity.crowded_edges;
  if (crossed > 0) {
    const auto& place = halves.core.crossed_at ? halves.core.crossed_at : halves.cavity.crossed_at;
    fmt::format_to(out, "          {} facets cross others by rounding, some near {}\n", crossed,
                   figures(*place, report.model.frame.diagonal));
  }
  if (const std::size_t needles = halves.core.needles + halves.cavity.needles; needles > 0) {
    const auto& place = halves.core.needle_at ? halves.core.needle_at : halves.cavity.needle_at;
    fmt::format_to(out, "          {} facet{} thinner than {}, the longest near {}\n", needles,
                   needles == 1 ? " is" : "s are", error_text(1e-7 * report.model.frame.diagonal),
                   figures(*place, report.model.frame.diagonal));
  }
  if (touching > 0)
    fmt::format_to(out, "          a half touches itself in {} edge{}\n", touching, touching == 1 ? "" : "s");
  for (const WrittenBody& body : written.bodies) {
    if (!body.file.empty()) fmt::format_to(out, "          {}\n", body.file);
  }
  return text;
}

}  // namespace

std::string loop_near(const PartingLine& line, const glm::dvec3& place) {
  double least = INFINITY;
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < line.loops.size(); ++k) {
    for (const glm::dvec3& point : line.loops[k].points) {
      const double away = glm::distance(point, place);
      if (away >= least) continue;
      least = away;
      nearest = k;
    }
  }
  return line.loops.empty() ? "" : fmt::format("{} {}", loop_name(line.loops[nearest].kind), nearest + 1);
}

std::string refusal_text(const PartModel& model, const MoldHalves& halves, const WrittenMold& written,
                         std::string_view loop) {
  if (written.refusal.empty()) return {};
  std::string text = "no halves: " + written.refusal;
  if (halves.refused_at) text += ", near " + figures(*halves.refused_at, model.frame.diagonal);
  if (!loop.empty()) text += fmt::format(", at loop {}", loop);
  return halves.change.empty() ? text : text + "; " + halves.change;
}

std::string unfilled_text(const PartModel& model, const MoldSettings& settings, const MoldHalves& halves) {
  constexpr std::size_t k_most_places = 3;
  if (halves.inserts.empty() || settings.fill_undercut) return {};
  std::string places;
  for (std::size_t k = 0; k < std::min(halves.inserts.size(), k_most_places); ++k)
    places += fmt::format("{}{}", k == 0 ? "" : "; ", figures(insert_place(halves, k), model.frame.diagonal));
  return fmt::format("undercuts keep {} {} in {} place{} from both halves, at {}{}",
                     figure(halves.insert_volume), powered_unit(model.part, 3), halves.inserts.size(),
                     halves.inserts.size() == 1 ? "" : "s", places,
                     halves.inserts.size() > k_most_places ? "; …" : "");
}

std::vector<std::string> missed_lines(const PartModel& model, const MoldHalves& halves) {
  std::vector<std::string> lines;
  for (const auto& [missed, why] :
       {std::pair(&halves.missed_leaning, "they lean against it or are hidden"),
        {&halves.missed_upright, "the parting surface would have to be steeper there"}}) {
    if (!missed->at) continue;
    lines.push_back(fmt::format("{} {} of the faces that a half was to form, near {}, it cannot: {}",
                                figure(missed->area), powered_unit(model.part, 2),
                                figures(*missed->at, model.frame.diagonal), why));
  }
  return lines;
}

nlohmann::ordered_json mold_json(const MoldReport& report) {
  const auto& [model, query, settings, assignment, line, halves, written, plan, by_action] = report;
  Json json;
  json["schema"] = "moldlight.mold/1";
  std::vector<std::string> warnings = model.warnings;
  warnings.insert(warnings.end(), assignment.warnings.begin(), assignment.warnings.end());
  json["part"] = part_json(model, warnings);
  json["direction"] = point_json(assignment.direction);
  json["settings"] = options_json(method_options(), query.method);
  json["settings"].update(options_json(mold_options(), settings));
  json["assignment"] = {{"core", assignment.area(MoldSide::core)},
                        {"cavity", assignment.area(MoldSide::cavity)},
                        {"action", assignment.area(MoldSide::action)},
                        {"free", assignment.free_area},
                        {"reverse_draft", assignment.reverse_draft_area},
                        {"height", assignment.height},
                        {"energy", assignment.energy},
                        {"energy_all_to_core", assignment.energy_to_core},
                        {"energy_all_to_cavity", assignment.energy_to_cavity}};
  json["euler"] = euler_json(line.euler);
  json["loops"] = Json::array();
  for (const PartingLoop& loop : line.loops) json["loops"].push_back(loop_json(loop));
  add_halves(report, json);
  json["verdict"] = parting_verdict(assignment, line, model.frame.diagonal);
  return json;
}

namespace {

/// What accounts for loops that are fewer or more than the part's handles ask for.
std::string difference_text(const EulerCheck& e) {
  if (e.loops == e.expected_loops) return {};
  const auto several = [](std::int64_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text = "; the difference is accounted for by ";
  if (!e.accounted()) text = "; the difference is not accounted for by ";
  text += fmt::format("{} of core, {} of cavity and {} of side actions",
                      several(static_cast<std::int64_t>(e.core_pieces), "piece"), e.cavity_pieces,
                      e.action_pieces);
  text += fmt::format(" with {}, {} and {} borders", e.borders[0], e.borders[1], e.borders[2]);
  std::int64_t handles = 0;
  for (const MoldSide side : k_mold_sides) handles += e.twice_handles(side) / 2;
  return handles == 0 ? text : text + " and " + several(handles, "handle");
}

}  // namespace

std::string mold_table(const MoldReport& report) {
  const auto& [model, query, settings, assignment, line, halves, written, plan, by_action] = report;
  constexpr std::size_t k_most_rows = 20;
  const std::string unit = length_unit(model.part), area_unit = powered_unit(model.part, 2);
  const FigureColumn areas(assignment.total_area), lengths(10.0 * model.frame.diagonal);
  std::string text =
      fmt::format("{} along {}: {}\n\n", part_name(model.part), figures(assignment.direction, 1.0),
                  parting_verdict(assignment, line, model.frame.diagonal));
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:<9}{:>17}{:>10}\n", "formed by", "area " + area_unit, "share");
  for (const MoldSide side : k_mold_sides) {
    fmt::format_to(out, "{:<9}{:>16}{:>10}\n", side_name(side), areas.text(assignment.area(side)),
                   share_text(assignment.area(side), assignment.total_area));
  }
  fmt::format_to(out, "either could form {} {}", areas.text(assignment.free_area), area_unit);
  if (assignment.reverse_draft_area > 0.0)
    fmt::format_to(out, "; {} {} leans against its half, by less than the soft draft",
                   areas.text(assignment.reverse_draft_area), area_unit);
  text += "\n\n";
  if (!line.loops.empty()) {
    fmt::format_to(out, "{:>4}  {:<9}{:>12}{:>12}{:>12}{:>12}{:>10}{:>10}{:>8}\n", "#", "loop",
                   "length " + unit, "climb " + unit, "flat to " + unit, "steep " + unit, "sharpest",
                   "on crease", "breaks");
  }
  for (std::size_t k = 0; k < std::min(line.loops.size(), k_most_rows); ++k) {
    const PartingLoop& loop = line.loops[k];
    fmt::format_to(out, "{:>4}  {:<9}{:>12}{:>12}{:>12}{:>12}{:>9.1f}°{:>9.1f}%{:>8}\n", k + 1,
                   loop_name(loop.kind), lengths.text(loop.length), lengths.text(loop.climb()),
                   lengths.text(loop.flatness), lengths.text(loop.steep_length), loop.sharpest_deg,
                   100.0 * loop.on_crease, loop.breaks);
  }
  if (line.loops.size() > k_most_rows) fmt::format_to(out, "      … {} in all\n", line.loops.size());
  const EulerCheck& e = line.euler;
  fmt::format_to(out,
                 "\ncheck {}  Euler characteristics: core {} + cavity {} + actions {} = part {}{}\n"
                 "check {}  {} loops of core and cavity; genus {} asks for {}{}\n",
                 e.sums() ? "✓" : "✗", e.core, e.cavity, e.action, e.part,
                 e.touching == 0 ? "" : fmt::format(" + {} where lines touch", e.touching),
                 e.accounted() ? "✓" : "✗", e.loops, e.genus, e.expected_loops, difference_text(e));
  return text + halves_table(report);
}

}  // namespace moldlight
