#include "session/classify_report.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "io/file_format.hpp"
#include "session/figures.hpp"
#include "session/method_options.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

Json point_json(const glm::dvec3& point) { return {point.x, point.y, point.z}; }

/// What part of `whole` a value is; 0 for a part without area.
double share(double value, double whole) { return whole > 0.0 ? value / whole : 0.0; }

Json settings_json(const Classification& result) {
  Json settings = options_json(method_options(), result.settings);
  settings.erase("direction");
  settings["backend"] = result.backend;
  settings["renderer"] = result.renderer;
  return settings;
}

Json faces_json(const std::vector<SourceAreas>& faces) {
  Json list = Json::array();
  for (const SourceAreas& face : faces) {
    Json entry = {{"face", face.source}, {"area", face.areas.total()}};
    for (const Region region : k_regions) entry[std::string(region_name(region))] = face.areas[region];
    list.push_back(std::move(entry));
  }
  return list;
}

/// SGR codes of the paper's colours.
std::string_view terminal_colour(Region region) {
  switch (region) {
    case Region::core:
      return "\033[34m";
    case Region::cavity:
      return "\033[32m";
    case Region::both:
      return "\033[90m";
    case Region::undercut:
      return "\033[31m";
  }
  return "";
}

constexpr std::string_view k_plain = "\033[0m";

}  // namespace

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
          {"bounds", {{"min", point_json(health.bounds.min)}, {"max", point_json(health.bounds.max)}}},
          {"warnings", warnings},
          {"repairs", model.part.repairs}};
}

std::vector<SourceAreas> face_areas(const PartModel& model, const Classification& result) {
  if (model.part.facet_source.empty()) return {};
  return region_areas_by_source(model.part.facet_source, model.geometry.areas, result.facet_fractions);
}

Json classify_json(const PartModel& model, const Classification& result) {
  Json areas, fractions;
  for (const Region region : k_regions) {
    areas[std::string(region_name(region))] = result.areas[region];
    fractions[std::string(region_name(region))] = share(result.areas[region], result.total_area);
  }
  areas["total"] = result.total_area;
  areas["near_vertical"] = result.near_vertical_area;
  const UndercutUncertainty& uncertainty = result.uncertainty;
  const ProjectedUndercut& projected = result.projected;
  Json json = {{"schema", "moldlight.classify/1"},
               {"part", part_json(model, result.warnings)},
               {"direction", point_json(result.direction)},
               {"settings", settings_json(result)},
               {"texel", result.texel},
               {"lateral_tolerance", result.lateral_tolerance},
               {"areas", areas},
               {"fractions", fractions},
               {"undercut_uncertainty", uncertainty.total},
               {"uncertainty_parts",
                {{"sampling", uncertainty.sampling},
                 {"audit", uncertainty.audit},
                 {"unsettled", uncertainty.unsettled}}},
               {"projected_undercut",
                {{"surface", projected.surface},
                 {"identity", projected.identity},
                 {"gap", projected.gap},
                 {"gap_limit", projected.gap_limit},
                 {"agrees", projected.agrees()}}},
               {"samples",
                {{"total", result.samples},
                 {"doubtful", result.doubtful_samples},
                 {"settled", result.settled_samples},
                 {"audited", result.audited_samples},
                 {"audited_wrong", result.audited_wrong}}},
               {"timings_ms",
                {{"load", result.timings.load_ms},
                 {"maps", result.timings.maps_ms},
                 {"measure", result.timings.measure_ms},
                 {"total", result.timings.total_ms}}}};
  if (model.part.format == format_name(FileFormat::step))
    json["faces"] = faces_json(face_areas(model, result));
  return json;
}

std::string classify_table(const PartModel& model, const Classification& result, bool colour) {
  const std::string area_unit = powered_unit(model.part, 2);
  const FigureColumn areas(result.total_area);
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}: {} facets, {}; box {} {}\n", part_name(model.part), model.health.facets,
                 model.health.closed ? "closed" : "not closed",
                 figures(model.health.bounds.max - model.health.bounds.min, model.frame.diagonal),
                 length_unit(model.part));
  fmt::format_to(out, "direction {}; draft tolerance {}°, lateral tolerance {} {}\n\n",
                 figures(result.direction, 1.0), figure(result.settings.tau_deg),
                 figure(result.lateral_tolerance), length_unit(model.part));

  const std::string heading = "area " + area_unit;
  // The superscript takes two bytes and one column.
  fmt::format_to(out, "{:<9}{:>{}}{:>10}\n", "region", heading, 17, "share");
  for (const Region region : k_regions) {
    const std::string name = fmt::format("{:<9}", region_name(region));
    fmt::format_to(
        out, "{}{:>16}{:>8.2f} %{}\n",
        colour ? fmt::format("{}{}{}", terminal_colour(region), name, k_plain) : name,
        areas.text(result.areas[region]), 100.0 * share(result.areas[region], result.total_area),
        region == Region::undercut ? fmt::format("   ± {}", areas.text(result.uncertainty.total)) : "");
  }
  fmt::format_to(out, "{:<9}{:>16}{:>8.2f} %\n\n", "total", areas.text(result.total_area),
                 result.total_area > 0.0 ? 100.0 : 0.0);
  fmt::format_to(
      out,
      "check {}  hidden from both sides, projected along the direction: {} by samples, {} by shadow "
      "area;\n         they are {} apart, {} {}\n",
      result.projected.agrees() ? "✓" : "✗", areas.text(result.projected.surface),
      areas.text(result.projected.identity), areas.text(std::abs(result.projected.gap)),
      result.projected.agrees() ? "within" : "over the limit of", areas.text(result.projected.gap_limit));
  return text;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace moldlight
