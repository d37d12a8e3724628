#include "pieces/pieces_report.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "classify/figure_table.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"
#include "io/mesh_writer.hpp"
#include "mold/direction.hpp"
#include "parting/line_files.hpp"
#include "parting/mold_report.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_most_places = 100;

std::string number_word(std::size_t number) {
  constexpr std::array<std::string_view, 7> k_words = {"no", "one", "two", "three", "four", "five", "six"};
  return number < k_words.size() ? std::string(k_words[number]) : fmt::format("{}", number);
}

bool has_pair(const PiecesResult& result) {
  return result.count() == 2 &&
         opposite_pair(std::array{result.directions[0].direction, result.directions[1].direction});
}

std::string names_of(const PiecesResult& result) {
  std::vector<std::string> names;
  for (const PieceDirection& one : result.directions) names.push_back(pull_words(one.direction));
  return fmt::format("{}", fmt::join(names, "; "));
}

Json settings_json(const PiecesResult& result, double diagonal) {
  Json settings = {{"tau_deg", result.query.tau_deg}, {"tolerance", result.query.lateral * diagonal}};
  settings.update(options_json(pieces_options(), result.settings));
  settings["directions"] = Json::array();
  for (const glm::dvec3& direction : result.settings.proposed)
    settings["directions"].push_back(point_json(direction));
  return settings;
}

/// How many undercuts flexible pieces leave, the greatest strain among them, and what must be cut.
std::string stretch_sentences(const PartModel& model, const PiecesResult& result) {
  std::size_t enclosed = 0, cuts = 0;
  double most = 0.0;
  for (const StretchedUndercut& stretch : result.stretches) {
    enclosed += stretch.depth || stretch.neck ? 0 : 1;
    if (stretch.neck) most = std::max(most, stretch.neck->strain());
  }
  for (const std::size_t of_piece : result.cuts.value_or(std::vector<std::size_t>())) cuts += of_piece;
  const auto verb = [](std::size_t count, std::string_view one, std::string_view more) {
    return count == 1 ? one : more;
  };
  std::string text = fmt::format(
      "{} along {} {} {}, {} {}.", plural(result.count(), "flexible piece"), names_of(result),
      verb(result.count(), "leaves", "leave"),
      result.stretches.empty() ? "only shallow undercuts" : plural(result.stretches.size(), "undercut"),
      rounded_area(result.left_area, model.geometry.total_area), powered_unit(model.part, 2));
  if (most > 0.0)
    text += fmt::format(" The tightest neck asks for {} strain; the elongation given is {:g} %.",
                        share_text(most, 1.0), result.settings.elongation_pct);
  if (enclosed > 0) text += fmt::format(" Nothing leads past the lip of {}.", plural(enclosed, "undercut"));
  if (cuts > 0)
    text += fmt::format(" {} of the pieces {} through a tunnel of the part and must be cut.",
                        plural(cuts, "loop"), verb(cuts, "goes", "go"));
  return text;
}

Json flexible_json(const PiecesResult& result) {
  if (!result.flexible()) return {};
  Json undercuts = Json::array();
  for (std::size_t k = 0; k < result.stretches.size(); ++k) {
    const auto& [place, direction, depth, neck] = result.stretches[k];
    undercuts.push_back({{"order", direction + 1},
                         {"area", result.places[place].area},
                         {"centre", point_json(result.places[place].centre)},
                         {"depth", depth ? Json(*depth) : Json()},
                         {"neck", neck ? Json{{"perimeter", neck->perimeter},
                                              {"widest", neck->widest},
                                              {"strain_pct", 100.0 * neck->strain()}}
                                       : Json()}});
  }
  return {{"undercuts", undercuts}, {"cuts", result.cuts ? Json(*result.cuts) : Json()}};
}

Json solids_json(const PieceSolids& solids) {
  const MoldHalves& halves = solids.halves;
  Json refused, bodies = Json::array();
  if (!solids.refusal.empty()) {
    refused = {{"why", solids.refusal}, {"place", point_json(solids.refused_at)}};
  }
  for (std::size_t k = 0; k < solids.solids.size(); ++k) {
    const auto& [direction, travel, sequence] = solids.solids[k];
    Json body = written_body_json(halves.written.bodies[k]);
    body.update({{"name", halves.written.bodies[k].name},
                 {"order", direction ? Json(*direction + 1) : Json()},
                 {"direction", direction ? point_json(solids.directions[*direction]) : Json()},
                 {"travel", direction ? Json(travel) : Json()},
                 {"sequence", sequence > 0 ? Json(sequence) : Json()}});
    bodies.push_back(std::move(body));
  }
  const bool made = refused.is_null();
  return {{"refused", refused},
          {"bodies", bodies},
          {"block_volume", made ? Json(halves.block_volume) : Json()},
          {"volume_gap", made ? Json(halves.volume_gap) : Json()},
          {"transform", made ? mold_transform_json(halves) : Json()}};
}

}  // namespace

std::string pieces_state(const PiecesResult& result) {
  return result.flexible() && !result.releases_all ? "stretched"
         : !result.releases_all                    ? "left-over"
         : has_pair(result)                        ? "two-piece"
                                                   : "pieces";
}

std::string pieces_sentence(const PartModel& model, const PiecesResult& result) {
  const std::string left =
      fmt::format("{} {} ({})", rounded_area(result.left_area, model.geometry.total_area),
                  powered_unit(model.part, 2), share_text(result.left_area, model.geometry.total_area));
  const std::size_t count = result.count();
  if (count == 0) return "No direction that was tried releases any of the surface.";
  if (result.flexible() && !result.releases_all) return stretch_sentences(model, result);
  if (!result.enough)
    return fmt::format("{} directions are not enough: {} of the surface is left over.", count, left);
  std::string text;
  if (!result.releases_all) {
    text = fmt::format("No direction releases {} of the surface. The rest needs {}: {}.", left,
                       plural(count, "direction"), names_of(result));
  } else if (has_pair(result)) {
    text = fmt::format("Two pieces release the part: it opens along {}.",
                       pull_words(result.directions[0].direction));
  } else if (count == 2) {
    text = fmt::format("Two pieces that are not opposite release the part: {}.", names_of(result));
  } else {
    text = fmt::format("The mold opens along {}: {}.", plural(count, "direction"), names_of(result));
  }
  if (count < 2 || (count == 2 && result.proved())) return text;
  if (result.proved())
    return text + " " +
           sentence_of(fmt::format("{} are impossible (proved for {} samples of the surface)",
                                   number_word(count - 1), result.proof_samples));
  if (!result.optimal) return text + " The search was cut short, so fewer may do.";
  return text +
         fmt::format(" No smaller set of the directions tried releases as much. At least {} needed (proved).",
                     result.lower_bound == 1 ? "one is" : number_word(result.lower_bound) + " are");
}

Colour piece_colour(std::size_t direction, Palette palette) {
  if (direction < 2) return region_colour(direction == 0 ? Region::core : Region::cavity, palette);
  return action_colour(direction - 2);
}

std::string solids_refusal(const PartModel& model, const PieceSolids& solids) {
  if (solids.refusal.empty()) return {};
  const std::string text = "no solids: " + solids.refusal;
  return solids.refused_at ? text + ", near " + FigureStyle(model).point(*solids.refused_at) : text;
}

Json pieces_json(const PartModel& model, const PiecesResult& result, const PieceSolids* solids,
                 const MoldSettings& mold) {
  Json directions = Json::array(), places = Json::array(), seams = Json::array(), pieces = Json::array(),
       open = Json::array();
  for (std::size_t k = 0; k < result.count(); ++k) {
    const PieceDirection& one = result.directions[k];
    directions.push_back({{"direction", point_json(one.direction)},
                          {"name", one.name},
                          {"order", k + 1},
                          {"area", one.area},
                          {"components", one.components}});
  }
  for (std::size_t k = 0; k < std::min(result.places.size(), k_most_places); ++k) {
    const LeftPlace& place = result.places[k];
    places.push_back(
        {{"area", place.area}, {"centre", point_json(place.centre)}, {"bounds", bounds_json(place.bounds)}});
  }
  for (const PieceSeam& seam : result.formed.seams) {
    seams.push_back({{"orders", {seam.a + 1, seam.b + 1}},
                     {"length", seam.length},
                     {"closed", seam.closed},
                     {"crease_share", seam.crease_share}});
  }
  for (const FormedPatch& patch : result.formed.patches) {
    pieces.push_back(
        {{"order", patch.direction + 1}, {"area", patch.area}, {"centre", point_json(patch.centre)}});
  }
  for (const OpenCell& cell : result.proof.open)
    open.push_back({{"direction", point_json(cell.direction)}, {"radius_deg", cell.radius_deg}});
  Json air;
  if (result.enclosed_air) air = {{"volume", *result.enclosed_air}, {"error", result.enclosed_error}};
  Json settings = settings_json(result, model.frame.diagonal);
  if (solids != nullptr) settings.update(options_json(pieces_solid_options(), mold));
  return {{"schema", "moldlight.pieces/1"},
          {"part", part_json(model, model.warnings)},
          {"settings", settings},
          {"verdict", {{"state", pieces_state(result)}, {"sentence", pieces_sentence(model, result)}}},
          {"directions", directions},
          {"count", result.count()},
          {"lower_bound", result.lower_bound},
          {"proved", result.proved()},
          {"optimal", result.optimal},
          {"proof", {{"samples", result.proof_samples}, {"cells", result.proof.cells}, {"open", open}}},
          {"left", {{"area", result.left_area}, {"places", places}}},
          {"flexible", flexible_json(result)},
          {"seams", seams},
          {"pieces", pieces},
          {"solids", solids == nullptr ? Json() : solids_json(*solids)},
          {"void", air},
          {"elapsed_s", result.elapsed_s}};
}

Classification formed_part(const PartModel& model, const PiecesResult& result) {
  Classification shown;
  shown.direction = result.directions.empty() ? glm::dvec3(0, 0, 1) : result.directions.front().direction;
  shown.total_area = model.geometry.total_area;
  auto split = std::make_shared<SplitMesh>(result.formed.mesh);
  for (std::size_t k = 0; k < split->pieces.size(); ++k) {
    const std::uint32_t by = result.formed.formed_by[k];
    split->pieces[k].region = by == 0 ? Region::core : by == 1 ? Region::cavity : Region::undercut;
  }
  if (result.directions.empty()) {
    split->vertices = model.part.mesh.vertices;
    for (FacetIndex facet = 0; facet < model.part.mesh.facets.size(); ++facet)
      split->pieces.push_back({model.part.mesh.facets[facet], facet, Region::undercut});
  }
  shown.split = std::move(split);
  return shown;
}

glm::dvec3 pulled_by(const PartModel& model, const PieceSolids& solids, std::size_t body) {
  constexpr double k_gap = 0.15;  // beside the part, in diagonals
  const auto& [direction, travel, sequence] = solids.solids[body];
  return direction ? (travel + k_gap * model.frame.diagonal) * solids.directions[*direction]
                   : glm::dvec3(0.0);
}

std::vector<StillBody> pulled_pieces(const PartModel& model, const PieceSolids& solids, Palette palette) {
  const MoldHalves& halves = solids.halves;
  std::vector<StillBody> bodies;
  for (std::size_t k = 0; k < solids.solids.size(); ++k) {
    const MoldBody& solid = k == 0 ? halves.core : k == 1 ? halves.cavity : halves.inserts[k - 2];
    StillBody body{.mesh = in_part(halves, solid.mesh),
                   .colour = region_colour(Region::undercut, palette),
                   .label = halves.written.bodies[k].name};
    std::ranges::replace(body.label, '_', ' ');
    body.motion = glm::translate(body.motion, pulled_by(model, solids, k));
    if (solids.solids[k].direction) body.colour = piece_colour(*solids.solids[k].direction, palette);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

void write_pieces_mesh(const std::string& path, const PartModel& model, const PiecesResult& result,
                       Palette palette) {
  std::vector<MeshGroup> groups;
  for (std::size_t k = 0; k < result.count(); ++k)
    groups.push_back({piece_name(k), piece_colour(k, palette)});
  groups.push_back({"left_over", region_colour(Region::undercut, palette)});
  write_grouped_mesh(path, {.mesh = piece_mesh(result.formed.mesh),
                            .groups = groups,
                            .of_facet = result.formed.formed_by,
                            .what = "piece",
                            .title = "mold pieces",
                            .unit = model.part.unit,
                            .name = part_name(model.part),
                            .values = [&] { return split_values(model, result.formed.mesh, std::nullopt); }});
}

void write_seams(const std::string& path, const PartModel& model, const PiecesResult& result) {
  WrittenLines lines{
      .loops = {},
      .direction = result.directions.empty() ? glm::dvec3(0, 0, 1) : result.directions.front().direction,
      .unit = model.part.unit,
      .name = part_name(model.part),
      .title = "seams of mold pieces"};
  for (const PieceSeam& seam : result.formed.seams)
    lines.loops.push_back({.kind = "seam", .points = seam.points, .open = true});
  write_lines(path, lines);
}

}  // namespace moldlight
