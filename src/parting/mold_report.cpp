#include "parting/mold_report.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"
#include "mold/direction.hpp"
#include "parting/mold_figures.hpp"

namespace moldlight {

namespace {

Json loop_json(const PartingLoop& loop) {
  Json json = {{"kind", loop_name(loop.kind)}};
  put_figures(found_figures(loop_figures(), loop), json);
  json["points"] = Json::array();
  for (const glm::dvec3& point : loop.points) json["points"].push_back(point_json(point));
  return json;
}

Json half_json(const WrittenBody& written, const MoldBody& body) {
  Json json = written_body_json(written);
  json["undercut"] = written.undercut;
  put_figures(found_figures(half_figures(), body), json);
  json["crossed_at"] = point_json(body.crossed_at);
  json["needle_at"] = point_json(body.needle_at);
  return json;
}

Json contacts_json(const MoldHalves& halves) {
  Json list = Json::array();
  for (const ContactWall& wall : halves.contacts)
    list.push_back({{"place", point_json(wall.place)}, {"height", wall.height}, {"area", wall.area}});
  return list;
}

Json missed_json(const MissedFaces& missed) {
  return {{"area", missed.area}, {"place", point_json(missed.at)}};
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
          {"place", point_json(halves.refused_at)},
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

}  // namespace

std::string block_text(const PartModel& model, const MoldHalves& halves) {
  const glm::dvec2 size = halves.scale * model.frame.diagonal * (halves.block_high - halves.block_low);
  return fmt::format(
      "{} × {} × {}", rounded(size.x), rounded(size.y),
      FigureStyle(model).with_unit(FigureKind::length, halves.block_volume / (size.x * size.y)));
}

namespace {

/// "8 shut-offs, planar parting surface, flat edge, 1 slide; block of 117 × 89 × 62 mm": of what was made.
std::string made_text(const MoldReport& report) {
  constexpr double k_flat = 1e-4;  // of the diagonal
  const MoldHalves& halves = report.halves;
  const SurfaceFigures& surface = halves.surface;
  const FigureStyle style(report.model);
  const double flat = k_flat * report.model.frame.diagonal;
  const auto length = [&](double value) { return style.with_unit(FigureKind::length, value); };
  const auto rises = [&](double by, std::string_view level, std::string_view what) {
    return by <= flat ? std::string(level) : fmt::format("{} rises by {}", what, length(by));
  };
  const auto shut_offs =
      static_cast<std::size_t>(std::ranges::count_if(report.line.loops, [](const PartingLoop& loop) {
        return loop.kind == LoopKind::shut_off && !loop.tiny;
      }));
  std::string text =
      fmt::format("{}, {}, {}", shut_offs == 0 ? std::string("no shut-off") : plural(shut_offs, "shut-off"),
                  rises(surface.high - surface.low, "planar parting surface", "parting surface"),
                  rises(surface.rim_range(), "flat edge", "edge"));
  if (!halves.contacts.empty())
    text += fmt::format(", {} of steel on steel without draft", plural(halves.contacts.size(), "place"));
  for (const PieceKind kind : {PieceKind::slide, PieceKind::lifter, PieceKind::insert}) {
    if (const std::size_t count = halves.count(kind); count > 0)
      text += ", " + plural(count, piece_name(kind));
  }
  return text + "; block of " + block_text(report.model, halves);
}

/// Of a body as it is written, in the mold's sequence: slides, halves, lifters, and by hand what leaves with
/// the part.
Json piece_json(const MoldReport& report, std::size_t number) {
  const MoldHalves& halves = report.halves;
  const WrittenBody& written = report.written.bodies[number];
  const bool half = number < 2;
  const MoldBody& body = number == 0 ? halves.core : half ? halves.cavity : halves.inserts[number - 2];
  const bool moved = !half && body.kind != PieceKind::insert;
  Json json = {{"name", written.name}, {"kind", half ? written.name : piece_name(body.kind)}};
  json["file"] = written.file.empty() ? Json() : Json(written.file);
  json["direction"] = json["travel"] = Json();
  if (half) {
    json["direction"] = point_json(number == 0 ? halves.frame.z : glm::dvec3(0.0) - halves.frame.z);
    json["travel"] = halves.part_height;
  } else if (moved) {
    const SideAction& action = report.plan->actions[body.action];
    json["direction"] = point_json(action.direction);
    json["travel"] = action.travel;
  }
  json["sequence"] = half ? 2 : body.kind == PieceKind::slide ? 1 : moved ? 3 : 4;
  json.update({{"volume", written.volume},
               {"closed", written.closed},
               {"crossings", body.crossed_facets},
               {"thinnest", body.thinnest ? Json(*body.thinnest) : Json()}});
  return json;
}

/// Halves, surfaces, inserts; null where there are none.
void add_halves(const MoldReport& report, Json& json) {
  const MoldHalves& halves = report.halves;
  const WrittenMold& written = report.written;
  json["surface"] = json["surfaces"] = json["halves"] = json["volume_gap"] = Json();
  json["pieces"] = json["inserts"] = Json::array();
  json["transform"] = json["made"] = Json();
  json["refused"] = refusal_json(report);
  if (!halves.made()) return;
  put_figures(found_figures(halves_figures(), halves), json);
  Json& surfaces = json["surfaces"];
  surfaces["contacts"] = contacts_json(halves);
  surfaces["forced_at"] = point_json(halves.forced_at);
  if (written.bodies.size() < 2) {
    json["halves"] = Json();
    return;
  }
  json["halves"].update(
      {{"core", half_json(written.bodies[0], halves.core)},
       {"cavity", half_json(written.bodies[1], halves.cavity)},
       {"certified", halves.certified()},
       {"faults", half_faults(report.model, halves)},
       {"frame", written.part_frame ? "part" : "mold"},
       {"missed",
        {{"leaning", missed_json(halves.missed_leaning)}, {"upright", missed_json(halves.missed_upright)}}}});
  json["made"] = made_text(report);
  json["transform"] = mold_transform_json(halves);
  for (std::size_t k = 0; k < written.bodies.size(); ++k) json["pieces"].push_back(piece_json(report, k));
  for (std::size_t k = 0; k + 2 < written.bodies.size(); ++k) {
    Json insert = written_body_json(written.bodies[k + 2]);
    insert["place"] = point_json(insert_place(halves, k));
    if (report.pieces != nullptr) add_actions(*report.plan, report.pieces->of_inserts[k], insert);
    json["inserts"].push_back(std::move(insert));
  }
}

void add_piece_remarks(const ActionPlan& plan, const MoldPieces& pieces, std::vector<std::string>& remarks) {
  const auto named = [&](std::size_t action) {
    return fmt::format("{} along {}", facts(plan.actions[action].kind).singular,
                       direction_words(plan.actions[action].direction));
  };
  for (std::size_t k = 0; k < pieces.of_inserts.size(); ++k) {
    const MoldBody& body = pieces.halves.inserts[k];
    const InsertActions& of_insert = pieces.of_inserts[k];
    std::string movers;
    for (const std::size_t number : of_insert.actions)
      movers += (movers.empty() ? "" : " and ") + std::string("the ") + named(number);
    if (movers.empty()) continue;
    remarks.push_back(body.kind == PieceKind::insert
                          ? fmt::format("{} is formed by {}{}.", body.name, movers,
                                        of_insert.unreleased > 0 ? "; nothing releases the rest of it" : "")
                          : fmt::format("{} is {}.", body.name, movers));
  }
  std::map<std::tuple<ActionKind, std::string, std::string>, std::size_t> unmade;
  for (const UnmadeAction& one : pieces.unmade) {
    const SideAction& action = plan.actions[one.action];
    ++unmade[{action.kind, direction_words(action.direction), one.why}];
  }
  for (const auto& [what, number] : unmade) {
    const auto& [kind, direction, why] = what;
    remarks.push_back(
        number == 1
            ? fmt::format("The {} along {} stays an insert: {}.", facts(kind).singular, direction, why)
            : fmt::format("{} {} along {} stay inserts: {}.", number, facts(kind).plural, direction, why));
  }
}

}  // namespace

Json written_body_json(const WrittenBody& body) {
  Json json = {{"file", body.file.empty() ? Json() : Json(body.file)}};
  put_figures(found_figures(written_figures(), body), json);
  return json;
}

Json mold_transform_json(const MoldHalves& halves) {
  const glm::dmat4 transform = to_part_of(halves);
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row)
    rows.push_back({transform[0][row], transform[1][row], transform[2][row], transform[3][row]});
  return rows;
}

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
  if (halves.refused_at) text += ", near " + FigureStyle(model).point(*halves.refused_at);
  if (const std::size_t blank = loop.rfind(' '); blank != std::string_view::npos)
    text += fmt::format(", at {} loop{}", loop.substr(0, blank), loop.substr(blank));
  return halves.change.empty() ? text : text + "; " + halves.change;
}

std::string unfilled_text(const PartModel& model, const MoldSettings& settings, const MoldHalves& halves) {
  constexpr std::size_t k_most_places = 3;
  if (halves.inserts.empty() || settings.fill_undercut) return {};
  const FigureStyle style(model);
  std::string places;
  for (std::size_t k = 0; k < std::min(halves.inserts.size(), k_most_places); ++k)
    places += fmt::format("{}{}", k == 0 ? "" : "; ", style.point(insert_place(halves, k)));
  return fmt::format("undercuts hide {} in {} from both halves, at {}{}",
                     style.with_unit(FigureKind::volume, halves.insert_volume),
                     plural(halves.inserts.size(), "place"), places,
                     halves.inserts.size() > k_most_places ? "; …" : "");
}

std::vector<std::string> half_faults(const PartModel& model, const MoldHalves& halves) {
  std::vector<std::string> faults;
  if (!halves.made()) return faults;
  for (const auto& [name, half] : {std::pair("core", &halves.core), {"cavity", &halves.cavity}}) {
    if (half->crossed_facets > 0)
      faults.push_back(fmt::format(
          "{} of the {} cross{} others by rounding, near {}", plural(half->crossed_facets, "facet"), name,
          half->crossed_facets == 1 ? "es" : "", FigureStyle(model).point(*half->crossed_at)));
    if (half->nonmanifold_edges > 0)
      faults.push_back(
          fmt::format("the {} touches itself in {}", name, plural(half->nonmanifold_edges, "edge")));
  }
  if (halves.leans()) faults.push_back("walls of a half lean along its pull by rounding");
  return faults;
}

std::vector<std::string> missed_lines(const PartModel& model, const MoldHalves& halves) {
  const FigureStyle style(model);
  std::vector<std::string> lines;
  for (const auto& [missed, why] :
       {std::pair(&halves.missed_leaning, "they have reverse draft or are hidden"),
        {&halves.missed_upright, "the parting surface would be too steep there"}}) {
    if (!missed->at) continue;
    lines.push_back(fmt::format("A half cannot form {} of the faces given to it, near {}: {}",
                                style.with_unit(FigureKind::area, missed->area), style.point(*missed->at),
                                why));
  }
  return lines;
}

Json mold_settings_json(const MoldReport& report) {
  Json json = options_json(method_options(), report.query.method);
  json.update(options_json(mold_options(), report.settings));
  return json;
}

Json mold_json(const MoldReport& report) {
  const auto& [model, query, settings, assignment, line, halves, written, plan, pieces] = report;
  Json json;
  json["schema"] = "moldlight.mold/2";
  std::vector<std::string> warnings = model.warnings;
  warnings.insert(warnings.end(), assignment.warnings.begin(), assignment.warnings.end());
  json["part"] = part_json(model, warnings);
  json["direction"] = point_json(assignment.direction);
  json["settings"] = mold_settings_json(report);
  put_figures(found_figures(assignment_figures(), assignment), json["assignment"]);
  put_figures(found_figures(euler_figures(), line.euler), json["euler"]);
  json["loops"] = Json::array();
  for (const PartingLoop& loop : line.loops) json["loops"].push_back(loop_json(loop));
  add_halves(report, json);
  json["parting_line"] = parting_verdict(assignment, line, model);
  return json;
}

std::vector<std::string> halves_remarks(const MoldReport& report) {
  const PartModel& model = report.model;
  const MoldHalves& halves = report.halves;
  const FigureStyle style(model);
  const auto near = [&](const glm::dvec3& place) { return "near " + style.point(place); };
  std::vector<std::string> remarks;
  if (!halves.contacts.empty())
    remarks.push_back(
        fmt::format("Most of the steel on steel without draft is {}.", near(halves.contacts.front().place)));
  if (halves.forced_at)
    remarks.push_back(fmt::format("The part's outline {} {}. No parting surface follows all of it.",
                                  halves.forced_deg > 89.99
                                      ? std::string("has steps")
                                      : fmt::format("is up to {:.1f}° steep", halves.forced_deg),
                                  near(*halves.forced_at)));
  for (const std::string& line : missed_lines(model, halves)) remarks.push_back(line + ".");
  if (report.pieces != nullptr) remarks.push_back(sentence_of(made_text(report)));
  if (report.pieces != nullptr) add_piece_remarks(*report.plan, *report.pieces, remarks);
  for (const std::string& fault : half_faults(model, halves)) remarks.push_back(sentence_of(fault));
  return remarks;
}

std::string needles_text(const PartModel& model, const MoldHalves& halves) {
  const std::size_t needles = halves.core.needles + halves.cavity.needles;
  if (needles == 0) return {};
  return fmt::format(
      "{} thinner than {} {}, the longest near {}.",
      needles == 1 ? "1 facet of the halves is" : fmt::format("{} facets of the halves are", needles),
      error_text(1e-7 * model.frame.diagonal), length_unit(model.part),
      FigureStyle(model).point(*(halves.core.needle_at ? halves.core.needle_at : halves.cavity.needle_at)));
}

std::string difference_text(const EulerCheck& e) {
  if (e.loops == e.expected_loops) return {};
  std::string text = "; the difference is accounted for by ";
  if (!e.accounted()) text = "; the difference is not accounted for by ";
  text += fmt::format("{} of core, {} of cavity and {} of side actions", plural(e.core_pieces, "piece"),
                      e.cavity_pieces, e.action_pieces);
  text += fmt::format(" with {}, {} and {} borders", e.borders[0], e.borders[1], e.borders[2]);
  std::int64_t handles = 0;
  for (const MoldSide side : k_mold_sides) handles += e.twice_handles(side) / 2;
  return handles == 0 ? text : text + " and " + plural(handles, "handle");
}

}  // namespace moldlight
