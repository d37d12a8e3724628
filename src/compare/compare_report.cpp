#include "compare/compare_report.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

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
  const bool closed = comparison.surface.closed;
  Json list = Json::array();
  for (const ChangedPlace& place : comparison.surface.places) {
    list.push_back({{"gone", area_json(place.gone)},
                    {"new", area_json(place.fresh)},
                    {"volume", closed ? Json(place.volume.volume) : Json()},
                    {"volume_error", closed ? Json(place.volume.error) : Json()},
                    {"joined", place.joined},
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

}  // namespace

nlohmann::ordered_json compare_json(const Comparison& comparison) {
  const auto& [a, b, settings, alignment, scale, surface, undercuts, actions, remarks] = comparison;
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
  json["scale"] = scale ? Json{{"factor", scale->factor}, {"other_share", scale->other}} : Json();
  json["surface"] = {{"gone", area_json(surface.gone)},
                     {"new", area_json(surface.fresh)},
                     {"volume_elsewhere", surface.closed ? Json(surface.volume_elsewhere) : Json()}};
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

}  // namespace moldlight
