#include "classify/info_report.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "io/text_scanner.hpp"
#include "mesh/place_order.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_json_places = 1000;
constexpr std::size_t k_text_places = 10;

struct BodyFigures {
  double area = 0.0;  // model units squared
  Bounds bounds;
};

BodyFigures measure_body(const PartModel& model, const Body& body) {
  BodyFigures measured;
  const TriangleMesh& mesh = model.part.mesh;
  for (FacetIndex facet = body.first_facet; facet < body.first_facet + body.facet_count; ++facet) {
    measured.area += model.geometry.areas[facet];
    for (int corner = 0; corner < 3; ++corner) measured.bounds.add(mesh.corner(facet, corner));
  }
  return measured;
}

double total_length(const std::vector<EdgeChain>& chains) {
  return std::accumulate(chains.begin(), chains.end(), 0.0,
                         [](double sum, const EdgeChain& chain) { return sum + chain.length; });
}

Json chains_json(const Part& part, std::size_t edges, const std::vector<EdgeChain>& chains) {
  Json list = Json::array();
  for (const EdgeChain& chain : std::span(chains).first(std::min(chains.size(), k_json_places))) {
    list.push_back({{"edges", chain.edge_count()},
                    {"length", chain.length},
                    {"closed", chain.closed},
                    {"facet", file_facet(part, chain.facet)},
                    {"bounds", bounds_json(chain.bounds)}});
  }
  return {{"edges", edges}, {"length", total_length(chains)}, {"chains", chains.size()}, {"places", list}};
}

Json bodies_json(const PartModel& model) {
  Json list = Json::array();
  for (const Body& body : model.part.bodies) {
    const BodyFigures measured = measure_body(model, body);
    list.push_back({{"name", body.name},
                    {"first_facet", body.first_facet},
                    {"facets", body.facet_count},
                    {"area", measured.area},
                    {"bounds", bounds_json(measured.bounds)}});
  }
  return list;
}

/// Number of the file's polygons or CAD faces; 0 where each facet is its own.
std::size_t source_count(const Part& part) {
  std::size_t count = 0;
  for (const std::uint32_t source : part.facet_source) {
    if (source != k_no_facet) count = std::max(count, std::size_t{source} + 1);
  }
  return count;
}

void add_bodies(std::string& text, const PartModel& model) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\nbodies: {}\n", model.part.bodies.size());
  const FigureStyle style(model);
  std::size_t number = 0;
  for (const Body& body : model.part.bodies) {
    const BodyFigures measured = measure_body(model, body);
    fmt::format_to(out, "  {:>3}  {:>8} facets, area {}, centre {}{}{}\n", ++number, body.facet_count,
                   style.with_unit(FigureKind::area, measured.area), style.point(measured.bounds.center()),
                   body.name.empty() ? "" : "  ", clean_name(body.name));
  }
}

void add_chains(std::string& text, const PartModel& model, std::string_view kind,
                const std::vector<EdgeChain>& chains) {
  if (chains.empty()) return;
  const auto out = std::back_inserter(text);
  const FigureStyle style(model);
  fmt::format_to(out, "\n{} edges: {} {} of {} in all{}\n", kind, chains.size(),
                 chains.size() == 1 ? "chain" : "chains",
                 style.with_unit(FigureKind::length, total_length(chains)),
                 chains.size() > k_text_places ? fmt::format("; the {} longest", k_text_places) : "");
  fmt::format_to(out, "  {:>6}  {:>10}  {:<9}  {:>8}  place\n", "edges",
                 style.heading("length", FigureKind::length), "", "facet");
  for (const EdgeChain& chain : std::span(chains).first(std::min(chains.size(), k_text_places))) {
    fmt::format_to(out, "  {:>6}  {:>10}  {:<9}  {:>8}  around {}, {} across\n", chain.edge_count(),
                   style.text(FigureKind::length, chain.length), chain.closed ? "loop" : "open-ended",
                   file_facet(model.part, chain.facet), style.point(chain.bounds.center()),
                   style.with_unit(FigureKind::length, chain.bounds.diagonal()));
  }
}

void add_count(std::string& text, std::size_t count, std::string_view what) {
  fmt::format_to(std::back_inserter(text), "{:>8}  {}\n", count, what);
}

}  // namespace

DefectPlaces defect_places(const PartModel& model) {
  DefectPlaces places;
  const TriangleMesh& mesh = model.part.mesh;
  if (model.health.open_edges > 0) places.open = defect_chains(mesh, EdgeDefect::open);
  if (model.health.nonmanifold_edges > 0) places.nonmanifold = defect_chains(mesh, EdgeDefect::nonmanifold);
  if (model.health.inconsistent_edges > 0)
    places.inconsistent = defect_chains(mesh, EdgeDefect::inconsistent);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (model.geometry.areas[facet] <= 0.0) places.degenerate_facets.push_back(file_facet(model.part, facet));
  }
  std::ranges::sort(places.degenerate_facets);
  return places;
}

Json info_json(const PartModel& model, const DefectPlaces& places) {
  const std::span degenerate =
      std::span(places.degenerate_facets).first(std::min(places.degenerate_facets.size(), k_json_places));
  return {{"schema", "moldlight.info/1"},
          {"part", part_json(model, model.warnings)},
          {"source_polygons", source_count(model.part)},
          {"bodies", bodies_json(model)},
          {"defects",
           {{"open", chains_json(model.part, model.health.open_edges, places.open)},
            {"nonmanifold", chains_json(model.part, model.health.nonmanifold_edges, places.nonmanifold)},
            {"inconsistent", chains_json(model.part, model.health.inconsistent_edges, places.inconsistent)},
            {"degenerate",
             {{"facets", model.health.degenerate_facets},
              {"places", std::vector<std::int64_t>(degenerate.begin(), degenerate.end())}}},
            {"duplicate", {{"facets", model.health.duplicate_facets}}}}},
          {"timings_ms", {{"load", model.load_ms}}}};
}

std::string info_text(const PartModel& model, const DefectPlaces& places) {
  const HealthReport& health = model.health;
  const Part& part = model.part;
  const FigureStyle style(model);
  std::string text;
  const auto out = std::back_inserter(text);
  const std::size_t sources = source_count(part);
  fmt::format_to(out, "part        {}\n", part_name(part));
  fmt::format_to(out, "format      {}, {}\n", part.format,
                 part.unit.empty() ? "which names no unit; --unit sets it" : "unit " + part.unit);
  fmt::format_to(
      out, "facets      {}{}\n", health.facets,
      sources == 0 ? "" : fmt::format(", of {} {}", sources, part.has_cad_faces ? "faces" : "polygons"));
  fmt::format_to(out, "vertices    {}\nbodies      {}\n", health.vertices, health.components);
  fmt::format_to(out, "size        {} {}\n", style.point(health.bounds.max - health.bounds.min),
                 length_unit(part));
  fmt::format_to(out, "from, to    {} … {}\n", style.point(health.bounds.min),
                 style.point(health.bounds.max));
  fmt::format_to(out, "area        {}\n", style.with_unit(FigureKind::area, health.area));
  if (health.closed) {
    fmt::format_to(out, "volume      {}\n", style.with_unit(FigureKind::volume, health.volume));
  } else {
    fmt::format_to(out, "volume      not defined: the part is not closed\n");
  }

  text += "\n";
  add_count(text, health.open_edges, "open edges (used by one facet)");
  add_count(text, health.nonmanifold_edges, "non-manifold edges (used by more than two facets)");
  add_count(text, health.inconsistent_edges, "edges between facets that are wound in opposite ways");
  add_count(text, health.degenerate_facets, "facets without area");
  add_count(text, health.duplicate_facets, "duplicate facets");

  if (part.bodies.size() > 1) add_bodies(text, model);
  add_chains(text, model, "open", places.open);
  add_chains(text, model, "non-manifold", places.nonmanifold);
  add_chains(text, model, "inconsistently wound", places.inconsistent);
  if (!places.degenerate_facets.empty()) {
    const std::size_t shown = std::min(places.degenerate_facets.size(), k_text_places);
    fmt::format_to(out, "\nfacets without area: {}{}\n",
                   fmt::join(std::span(places.degenerate_facets).first(shown), ", "),
                   shown < places.degenerate_facets.size() ? ", …" : "");
  }
  if (!part.repairs.empty()) text += "\n";
  for (const std::string& repair : part.repairs) fmt::format_to(out, "repair: {}\n", repair);
  if (!model.warnings.empty()) text += "\n";
  for (const std::string& warning : model.warnings) fmt::format_to(out, "warning: {}\n", warning);
  if (model.warnings.empty()) text += "\nThe mesh is sound.\n";
  if (part.repairs.empty() && health.open_edges + health.inconsistent_edges > 0) {
    text +=
        "try: --repair weld joins vertices that nearly coincide. --repair full also corrects the winding and "
        "fills small holes.\n";
  }
  return text;
}

}  // namespace moldlight
