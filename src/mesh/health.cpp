#include "mesh/health.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "base/numbers.hpp"
#include "mesh/edge_table.hpp"

namespace moldlight {
namespace {

VertexIndex opposite_vertex(const TriangleMesh& mesh, HalfEdgeIndex half_edge) {
  return mesh.facets[half_edge / 3][(half_edge % 3 + 2) % 3];
}

/// Each facet is seen once: at the edge of its two lowest vertices.
std::size_t count_duplicates(const TriangleMesh& mesh, std::span<const EdgeUse> uses,
                             std::vector<VertexIndex>& thirds) {
  thirds.clear();
  for (const EdgeUse& use : uses) {
    const VertexIndex third = opposite_vertex(mesh, use.half_edge);
    if (third > use.high) thirds.push_back(third);
  }
  std::sort(thirds.begin(), thirds.end());
  return static_cast<std::size_t>(thirds.end() - std::unique(thirds.begin(), thirds.end()));
}

void count_edges(const TriangleMesh& mesh, HealthReport& report) {
  bool any = false, balanced = true;
  std::vector<VertexIndex> thirds;
  EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    std::size_t upward = 0;
    for (const EdgeUse& use : uses) upward += start_vertex(mesh, use.half_edge) == low ? 1 : 0;
    any = true;
    balanced = balanced && 2 * upward == uses.size();
    if (uses.size() == 1) ++report.open_edges;
    if (uses.size() == 2 && upward != 1) ++report.inconsistent_edges;
    if (uses.size() > 2) ++report.nonmanifold_edges;
    report.duplicate_facets += count_duplicates(mesh, uses, thirds);
  });
  report.closed = any && balanced;
}

std::size_t count_used_vertices(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) used[vertex] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

}  // namespace

double signed_volume(const TriangleMesh& mesh) {
  // About the box's center, so that a part far from the origin keeps its digits.
  const glm::dvec3 center = bounds(mesh).center();
  double six_volumes = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    six_volumes += glm::dot(mesh.corner(facet, 0) - center,
                            glm::cross(mesh.corner(facet, 1) - center, mesh.corner(facet, 2) - center));
  }
  return six_volumes / 6.0;
}

HealthReport health_report(const TriangleMesh& mesh, const FacetGeometry& geometry) {
  CHECK(geometry.areas.size() == mesh.facets.size());
  HealthReport report;
  report.facets = mesh.facets.size();
  report.vertices = count_used_vertices(mesh);
  report.components = connected_components(mesh).count;
  report.area = geometry.total_area;
  report.volume = signed_volume(mesh);
  report.bounds = bounds(mesh);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (is_collapsed(mesh.facets[facet]) || geometry.areas[facet] <= 0.0) ++report.degenerate_facets;
  }
  count_edges(mesh, report);
  return report;
}

std::vector<std::string> health_warnings(const HealthReport& report) {
  std::vector<std::string> warnings;
  if (report.area <= 0.0) {
    warnings.push_back("The part has no area: all figures are zero.");
    return warnings;
  }
  if (report.open_edges > 0) {
    warnings.push_back(
        fmt::format("{}: the part is not closed, so volume and regions seen through the gaps are in doubt.",
                    plural(report.open_edges, "open edge")));
  }
  if (report.inconsistent_edges > 0) {
    warnings.push_back(fmt::format(
        "{} between facets wound in opposite ways: some facets are inside out and their region is in doubt.",
        plural(report.inconsistent_edges, "edge")));
  }
  if (report.nonmanifold_edges > 0) {
    warnings.push_back(fmt::format(
        "{} shared by more than two facets: {}.", plural(report.nonmanifold_edges, "edge"),
        report.closed ? "bodies touch there, the figures hold" : "inside and outside are in doubt there"));
  }
  if (report.closed && report.volume < 0.0) {
    warnings.push_back("The part is inside out (its volume is negative): every region is in doubt.");
  }
  if (report.duplicate_facets > 0) {
    warnings.push_back(
        fmt::format("{}: their area counts twice.", plural(report.duplicate_facets, "duplicate facet")));
  }
  if (report.degenerate_facets > 0) {
    warnings.push_back(
        fmt::format("{} without area: left out of the figures.", plural(report.degenerate_facets, "facet")));
  }
  return warnings;
}

}  // namespace moldlight
