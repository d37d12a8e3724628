// The report of a comparison as JSON.

#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "compare/compare_figures.hpp"
#include "compare/comparison.hpp"

namespace moldlight {

namespace {

Json alignment_json(const Alignment& alignment) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({alignment.rotation[0][row], alignment.rotation[1][row], alignment.rotation[2][row]});
  return {
      {"rotation", rows},
      {"shift", point_json(alignment.shift)},
      {"residual", {{"rms", alignment.rms}, {"largest", alignment.largest}, {"median", alignment.median}}},
      {"mirrored", alignment.mirrored}};
}

Json area_json(const MeasuredArea& measured) { return {{"area", measured.area}, {"error", measured.error}}; }

Json volume_json(const MeasuredVolume& measured) {
  return {{"volume", measured.volume}, {"error", measured.error}};
}

Json steel_json(const Comparison& comparison, const std::optional<SteelChange>& steel) {
  if (!steel) return {};
  Json json = volume_json(steel->volume);
  json["area"] = steel->area;
  json["depth"] = steel->depth;
  json["centre"] = point_json(steel->centre);
  json["of"] = Json::array();
  for (const auto& [owner, area] : steel->of)
    json["of"].push_back({{"name", steel_owner_text(comparison, owner)}, {"area", area}});
  return json;
}

Json stretches_json(const std::vector<LineStretch>& stretches) {
  Json list = Json::array();
  for (const LineStretch& one : stretches)
    list.push_back({{"length", one.length}, {"farthest", one.farthest}, {"at", point_json(one.at)}});
  return list;
}

Json mold_json(const Comparison& comparison) {
  if (!comparison.mold) return {};
  const MoldChange& mold = *comparison.mold;
  return {{"sentence", mold_change_text(comparison, mold)},
          {"steel_to_cut", volume_json(mold.to_cut)},
          {"steel_to_add", volume_json(mold.to_add)},
          {"parting_line",
           {{"within", mold.line.within},
            {"new", stretches_json(mold.line.added)},
            {"gone", stretches_json(mold.line.gone)}}}};
}

Json places_json(const Comparison& comparison) {
  const bool closed = comparison.surface.closed;
  Json list = Json::array();
  for (std::size_t k = 0; k < comparison.surface.places.size(); ++k) {
    const ChangedPlace& place = comparison.surface.places[k];
    const PlaceSteel steel = comparison.mold ? comparison.mold->places[k] : PlaceSteel();
    list.push_back({{"gone", area_json(place.gone)},
                    {"new", area_json(place.added)},
                    {"volume", closed ? Json(place.volume.volume) : Json()},
                    {"volume_error", closed ? Json(place.volume.error) : Json()},
                    {"joined", place.joined},
                    {"steel_to_cut", steel_json(comparison, steel.cut)},
                    {"steel_to_add", steel_json(comparison, steel.add)},
                    {"centre", point_json(place.centre)},
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
                    {"centre", point_json(region.centre)},
                    {"bounds", bounds_json(region.bounds)}});
  }
  return list;
}

Json undercut_json(const UndercutReport& report) {
  const Undercut& undercut = report.undercut;
  return {{"area", undercut.area},
          {"depth", report.depth ? Json(*report.depth) : Json()},
          {"centre", point_json(undercut.centre)},
          {"size_across", undercut.size_across},
          {"size_along", undercut.size_along}};
}

Json action_json(const SideAction& action) {
  return {{"kind", facts(action.kind).name},
          {"direction", point_json(action.direction)},
          {"travel", action.travel},
          {"area", action.area}};
}

/// `a` and `b` are what the numbers count; `id` from 1, as `moldlight actions` counts them.
template <typename T, typename ToJson>
Json changes_json(const std::vector<MatchedChange>& changes, const std::vector<T>& a, const std::vector<T>& b,
                  const ToJson& to_json) {
  const auto side = [&](const std::vector<T>& all, const std::optional<std::size_t>& number) {
    if (!number) return Json();
    Json json = {{"id", *number + 1}};
    json.update(to_json(all[*number]));
    return json;
  };
  Json list = Json::array();
  for (const MatchedChange& change : changes)
    list.push_back(
        {{"change", change_name(change.kind)}, {"a", side(a, change.a)}, {"b", side(b, change.b)}});
  return list;
}

}  // namespace

Json compare_json(const Comparison& comparison) {
  const auto& [a, b, settings, alignment, scale, surface, undercuts, actions, mold, remarks] = comparison;
  Json json;
  json["schema"] = "moldlight.compare/1";
  json["a"] = part_json(*a.model, a.result.warnings);
  json["b"] = part_json(*b.model, b.result.warnings);
  json["direction"] = {{"a", point_json(a.result.direction)}, {"b", point_json(b.result.direction)}};
  json["settings"] = options_json(method_options(), a.result.settings);
  json["settings"].update(options_json(compare_options(), settings));
  json["settings"].update(options_json(action_options(), settings.actions));
  json["same_within"] = surface.tolerance.apart;
  json["tessellation"] = surface.chords;
  json["alignment"] = alignment ? alignment_json(*alignment) : Json();
  json["scale"] = scale ? Json{{"factor", scale->factor}, {"other_share", scale->other}} : Json();
  json["surface"] = {{"gone", area_json(surface.gone)},
                     {"new", area_json(surface.added)},
                     {"volume_elsewhere", surface.closed ? Json(surface.volume_elsewhere) : Json()}};
  json["places"] = places_json(comparison);
  json["mold"] = mold_json(comparison);
  std::vector<FoundFigure> differences;
  for (const FigureRow<ComparedPart>& row : region_figures())
    if (row.kind != FigureKind::error)
      differences.push_back({row.key, row.title, row.help, row.kind, *row.find(b) - *row.find(a)});
  put_figures(found_figures(region_figures(), a), json["regions"]["a"]);
  put_figures(found_figures(region_figures(), b), json["regions"]["b"]);
  put_figures(differences, json["regions"]["difference"]);
  json["regions"]["changed"] = changed_regions_json(surface);
  json["undercuts"] = nullptr;
  json["actions"] = nullptr;
  if (a.plan && b.plan) {
    json["undercuts"] = changes_json(undercuts, a.plan->undercuts, b.plan->undercuts, undercut_json);
    json["actions"] = changes_json(actions, a.plan->actions, b.plan->actions, action_json);
  }
  json["verdicts"] = {{"a", a.verdict ? verdict_json(*a.verdict) : Json()},
                      {"b", b.verdict ? verdict_json(*b.verdict) : Json()}};
  json["remarks"] = remarks;
  json["verdict"] = comparison_verdict(comparison);
  return json;
}

}  // namespace moldlight
