#include "classify/classify_report.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/check.hpp"
#include "base/shown_text.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_tables.hpp"
#include "io/mesh_writer.hpp"
#include "mesh/faces.hpp"
#include "mesh/place_order.hpp"
#include "mold/draft.hpp"

namespace moldlight {

namespace {

Json settings_json(const Classification& result) {
  Json settings = options_json(method_options(), result.settings);
  const auto if_used = [](const std::string& name) { return name.empty() ? Json() : Json(name); };
  settings["backend"] = if_used(result.backend);
  settings["renderer"] = if_used(result.renderer);
  return settings;
}

/// As shares of `whole`.
Json values_json(const RegionValues& values, double whole = 1.0) {
  Json json;
  for (const Region region : k_regions) json[std::string(region_name(region))] = share(values[region], whole);
  return json;
}

Json faces_json(const std::vector<SourceAreas>& faces) {
  Json list = Json::array();
  for (const SourceAreas& face : faces) {
    Json entry = {{"face", face.source}, {"area", face.areas.total()}};
    entry.update(values_json(face.areas));
    list.push_back(std::move(entry));
  }
  return list;
}

Json comparison_json(const MapComparison& comparison) {
  const double total = comparison.total();
  Json areas, shares, excess;
  for (const Region exact : k_regions) {
    const std::string name(region_name(exact));
    const RegionValues& row = comparison.areas[static_cast<std::size_t>(exact)];
    areas[name] = values_json(row);
    shares[name] = values_json(row, total);
    excess[name] = comparison.excess(exact);
  }
  return {{"differing_area", comparison.differing()},
          {"differing_share", share(comparison.differing(), total)},
          {"error", comparison.error},
          {"samples", comparison.samples},
          {"excess", excess},
          {"areas", areas},
          {"shares", shares}};
}

/// The number of each facet's face, as tables have it.
std::vector<std::uint32_t> faces_of_facets(const PartModel& model) {
  return model.part.has_cad_faces ? model.part.facet_source
                                  : part_faces(model.part, model.geometry, model.adjacency).of_facet;
}

void write_split(const OutputPaths& paths, const PartModel& model, const Classification& result,
                 Palette palette) {
  const SplitMesh& split = *result.split;
  const TriangleMesh mesh = piece_mesh(split);
  std::vector<Region> regions;
  regions.reserve(split.pieces.size());
  for (const SplitPiece& piece : split.pieces) regions.push_back(piece.region);
  const ColouredMesh coloured{.mesh = mesh,
                              .regions = regions,
                              .palette = palette,
                              .unit = model.part.unit,
                              .name = part_name(model.part),
                              .values = [&] { return split_values(model, split, result.direction); }};
  if (!paths.mesh.empty()) write_coloured_mesh(paths.mesh, coloured);
  if (!paths.split_folder.empty())
    write_region_stls(paths.split_folder, std::filesystem::path(model.part.file).stem().string(), coloured);
  if (!paths.borders.empty()) write_borders(paths.borders, split);
}

}  // namespace

Json point_json(const glm::dvec3& point) { return {point.x, point.y, point.z}; }
Json point_json(const std::optional<glm::dvec3>& point) { return point ? point_json(*point) : Json(); }

Json bounds_json(const Bounds& bounds) {
  return {{"min", point_json(bounds.min)}, {"max", point_json(bounds.max)}};
}

Json part_json(const PartModel& model, const std::vector<std::string>& warnings) {
  const HealthReport& health = model.health;
  return {{"file", model.part.file},
          {"format", model.part.format},
          {"unit", model.part.unit.empty() ? Json() : Json(model.part.unit)},
          {"facets", health.facets},
          {"vertices", health.vertices},
          {"components", health.components},
          {"closed", health.closed},
          {"area", health.area},
          {"volume", health.volume},
          {"bounds", bounds_json(health.bounds)},
          {"warnings", warnings},
          {"repairs", model.part.repairs}};
}

std::vector<SourceAreas> face_areas(const PartModel& model, const Classification& result) {
  if (result.facet_fractions.empty()) return {};
  return region_areas_by_source(faces_of_facets(model), model.geometry.areas, result.facet_fractions);
}

std::vector<FacetValues> split_values(const PartModel& model, const SplitMesh& split,
                                      const std::optional<glm::dvec3>& direction) {
  const std::vector<std::uint32_t> of_facet = faces_of_facets(model);
  std::vector<std::int32_t> faces, bodies;
  std::vector<double> drafts, heights;
  const auto& of_part = model.part.bodies;
  std::size_t body = 0;
  for (std::size_t k = 0; k < split.pieces.size(); ++k) {
    const FacetIndex facet = split.pieces[k].facet;
    if (facet < of_part[body].first_facet) body = 0;
    while (facet >= of_part[body].first_facet + of_part[body].facet_count) ++body;
    faces.push_back(static_cast<std::int32_t>(of_facet[facet]));
    bodies.push_back(static_cast<std::int32_t>(std::max(model.part.chosen_body, body + 1)));
    if (!direction) continue;
    drafts.push_back(draft_angle_deg(model.geometry.normals[facet], *direction));
    heights.push_back(glm::dot(split.middle(k), *direction));
  }
  std::vector<FacetValues> values = {{"face", std::move(faces)}, {"body", std::move(bodies)}};
  if (direction)
    values.insert(values.end(), {{"draft_deg", std::move(drafts)}, {"height", std::move(heights)}});
  return values;
}

Json classify_json(const PartModel& model, const Classification& result) {
  Json areas = values_json(result.areas);
  areas["total"] = result.total_area;
  areas["near_vertical"] = result.near_vertical_area;
  const UndercutUncertainty& uncertainty = result.uncertainty;
  const ShadowIdentity& identity = result.identity;
  Json json = {
      {"schema", "moldlight.classify/2"},
      {"part", part_json(model, result.warnings)},
      {"direction", point_json(result.direction)},
      {"settings", settings_json(result)},
      {"texel", result.texel},
      {"lateral_tolerance", result.lateral_tolerance},
      {"areas", areas},
      {"fractions", values_json(result.areas, result.total_area)},
      {"undercut_uncertainty", uncertainty.total()},
      {"uncertainty_parts",
       {{"rounding", uncertainty.rounding}, {"mesh", uncertainty.mesh}, {"readout", uncertainty.readout}}},
      {"sampled_facets", uncertainty.sampled_facets},
      {"projected_area", result.shadow_area},
      {"projected_undercut", result.projected_undercut},
      {"identity",
       {{"core", identity.core},
        {"cavity", identity.cavity},
        {"gap", identity.gap},
        {"gap_limit", identity.gap_limit},
        {"agrees", identity.agrees()}}},
      {"timings_ms",
       {{"load", result.timings.load_ms},
        {"regions", result.timings.regions_ms},
        {"readout", result.timings.readout_ms},
        {"total", result.timings.total_ms}}}};
  if (model.part.has_cad_faces && !result.facet_fractions.empty())
    json["faces"] = faces_json(face_areas(model, result));
  if (result.maps) json["compare_maps"] = comparison_json(*result.maps);
  return json;
}

std::string json_text(const Json& json) {
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  // What a terminal would obey stands in strings alone, where its escape is the same to whoever reads them.
  std::string shown;
  shown.reserve(text.size());
  for (std::string_view rest = text; !rest.empty();) {
    const auto plain = static_cast<std::size_t>(
        std::ranges::find_if(rest, [](char c) { return static_cast<unsigned char>(c) >= 0x7F; }) -
        rest.begin());
    shown += rest.substr(0, plain);
    rest.remove_prefix(plain);
    if (rest.empty()) break;
    const std::string_view bytes = rest.substr(0, utf8_length(rest));
    const char32_t letter = letters_of(bytes).front();
    shown += is_command_letter(letter) ? letter_escape(letter) : std::string(bytes);
    rest.remove_prefix(bytes.size());
  }
  return shown;
}

void write_outputs(const OutputPaths& paths, const PartModel& model, const Classification& result,
                   Palette palette) {
  if (paths.need_split()) {
    CHECK(result.split != nullptr);
    write_split(paths, model, result, palette);
  }
  if (!paths.facets.empty()) {
    write_facet_csv(paths.facets, {.areas = model.geometry.areas,
                                   .fractions = result.facet_fractions,
                                   .numbers = model.part.file_facets,
                                   .order = listed_facets(model.part)});
  }
  if (!paths.faces.empty()) write_face_csv(paths.faces, face_areas(model, result));
  if (!paths.json.empty()) write_file(paths.json, json_text(classify_json(model, result)));
}

}  // namespace moldlight
