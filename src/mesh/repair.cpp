#include "mesh/repair.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

/// Cuts of two facets are the same points, but for rounding.
constexpr double k_cut_share = 1e-9;

MeshInRepair start_repair(Part& part) {
  MeshInRepair state;
  state.mesh = std::move(part.mesh);
  state.origin.resize(state.mesh.facets.size());
  std::iota(state.origin.begin(), state.origin.end(), FacetIndex{0});
  for (std::uint32_t body = 0; body < part.bodies.size(); ++body) {
    state.body.insert(state.body.end(), part.bodies[body].facet_count, body);
  }
  return state;
}

/// Numbers that belong to the former facets, for the facets there are now.
std::vector<std::uint32_t> carried_over(const std::vector<std::uint32_t>& former,
                                        const std::vector<FacetIndex>& origin) {
  std::vector<std::uint32_t> values;
  values.reserve(origin.size());
  for (const FacetIndex facet : origin) {
    values.push_back(facet == k_no_facet ? k_no_facet : former.empty() ? facet : former[facet]);
  }
  return values;
}

/// Facets that fill holes go to the end of their body; the rest keep their order.
void finish_repair(MeshInRepair&& state, Part& part) {
  std::vector<FacetIndex> order(state.mesh.facets.size());
  std::iota(order.begin(), order.end(), FacetIndex{0});
  std::ranges::stable_sort(order, {}, [&](FacetIndex facet) { return state.body[facet]; });
  std::vector<FacetIndex> origin;
  part.mesh.vertices = std::move(state.mesh.vertices);
  part.mesh.facets.clear();
  std::vector<Body> bodies = part.bodies;
  for (Body& body : bodies) body.facet_count = 0;
  for (const FacetIndex facet : order) {
    part.mesh.facets.push_back(state.mesh.facets[facet]);
    origin.push_back(state.origin[facet]);
    ++bodies[state.body[facet]].facet_count;
  }
  FacetIndex first = 0;
  for (Body& body : bodies) {
    body.first_facet = first;
    first += body.facet_count;
  }
  std::erase_if(bodies, [](const Body& body) { return body.facet_count == 0; });
  part.bodies = std::move(bodies);
  part.mesh = weld_vertices(part.mesh);
  if (!part.facet_source.empty()) part.facet_source = carried_over(part.facet_source, origin);
  part.file_facets = carried_over(part.file_facets, origin);
}

}  // namespace

std::vector<std::string> RepairReport::sentences(const std::string& unit) const {
  std::vector<std::string> sentences;
  const auto say = [&](std::size_t count, const std::string& what) {
    if (count > 0) sentences.push_back(fmt::format("{} {}", count, what));
  };
  const std::string with_unit = unit.empty() ? "" : " " + unit;
  say(welded_vertices,
      fmt::format("vertices of open edges welded within {}{}", rounded(weld_tolerance), with_unit));
  say(collapsed_facets, "facets with two equal corners dropped");
  say(flattened_facets, "facets without area merged into their neighbours");
  say(duplicate_facets, "duplicate facets dropped");
  say(turned_facets, "facets turned for consistent winding");
  say(filled_holes, fmt::format("holes filled with {} facets of {}{} in all", added_facets,
                                rounded(filled_area), with_unit.empty() ? "" : with_unit + "²"));
  if (sentences.empty()) sentences.push_back("nothing to repair");
  if (open_edges_before != open_edges_after || open_edges_after > 0) {
    sentences.push_back(fmt::format("{} open edges before, {} after", open_edges_before, open_edges_after));
  }
  return sentences;
}

RepairReport repair_part(Part& part, const RepairOptions& options, const Progress& progress) {
  RepairReport report;
  if (options.level == RepairLevel::none) return report;
  const double diagonal = bounds(part.mesh).diagonal();
  require_within_part("--weld-tolerance", options.weld_tolerance, diagonal);
  report.weld_tolerance = options.weld_tolerance > 0.0 ? options.weld_tolerance : k_weld_share * diagonal;
  MeshInRepair state = start_repair(part);
  report.open_edges_before = count_open_edges(state.mesh);
  report.welded_vertices = weld_near_vertices(state.mesh, report.weld_tolerance, progress);
  if (options.level >= RepairLevel::full) {
    report.collapsed_facets = drop_collapsed_facets(state);
    report.flattened_facets = flatten_facets_without_area(state);
    // A union counts how many bodies are at a place.
    if (options.level == RepairLevel::full) report.duplicate_facets = drop_duplicate_facets(state);
    report.turned_facets = make_winding_consistent(state.mesh);
    const double hole_side = options.largest_hole * diagonal;
    const FilledHoles filled = fill_holes(state, hole_side * hole_side, options.hole_edges, progress);
    if (filled.holes > 0) report.flattened_facets += flatten_facets_without_area(state);
    report.filled_holes = filled.holes;
    report.added_facets = filled.facets;
    report.filled_area = filled.area;
  }
  report.open_edges_after = count_open_edges(state.mesh);
  const bool same_facets = options.level == RepairLevel::weld;
  std::vector<std::uint32_t> file_facets = part.file_facets;
  finish_repair(std::move(state), part);
  if (same_facets) part.file_facets = std::move(file_facets);
  part.repairs = report.sentences(part.unit);
  return report;
}

std::size_t close_cuts(Part& part, const Progress& progress) {
  const double tolerance = k_cut_share * bounds(part.mesh).diagonal();
  MeshInRepair state = start_repair(part);
  weld_near_vertices(state.mesh, tolerance, progress);
  drop_collapsed_facets(state);
  match_open_edges(state, tolerance);
  drop_duplicate_facets(state);
  flatten_facets_without_area(state);
  const std::size_t open = count_open_edges(state.mesh);
  finish_repair(std::move(state), part);
  return open;
}

}  // namespace moldlight
