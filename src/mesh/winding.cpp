#include <glm/geometric.hpp>

#include "mesh/edge_table.hpp"
#include "mesh/repair_steps.hpp"

namespace moldlight {

namespace {

/// A facet next to another; `agrees` where they run through the edge in opposite senses.
struct Neighbour {
  FacetIndex facet = k_no_facet;
  bool agrees = true;
};

std::vector<std::array<Neighbour, 3>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::array<Neighbour, 3>> neighbours(mesh.facets.size());
  EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const HalfEdgeIndex a = uses[0].half_edge, b = uses[1].half_edge;
    const bool agrees = start_vertex(mesh, a) != start_vertex(mesh, b);
    neighbours[facet_of(a)][a % 3] = {facet_of(b), agrees};
    neighbours[facet_of(b)][b % 3] = {facet_of(a), agrees};
  });
  return neighbours;
}

double area_of(const TriangleMesh& mesh, FacetIndex facet) {
  const glm::dvec3& a = mesh.corner(facet, 0);
  return 0.5 * glm::length(glm::cross(mesh.corner(facet, 1) - a, mesh.corner(facet, 2) - a));
}

}  // namespace

std::size_t make_winding_consistent(TriangleMesh& mesh) {
  const std::vector<std::array<Neighbour, 3>> neighbours = neighbours_of(mesh);
  std::vector<bool> seen(mesh.facets.size(), false), turned(mesh.facets.size(), false);
  std::size_t count = 0;
  std::vector<FacetIndex> patch;
  for (FacetIndex first = 0; first < mesh.facets.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    patch.assign(1, first);
    double area_kept = 0.0, area_turned = 0.0;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const FacetIndex facet = patch[next];
      (turned[facet] ? area_turned : area_kept) += area_of(mesh, facet);
      for (const Neighbour& neighbour : neighbours[facet]) {
        if (neighbour.facet == k_no_facet || seen[neighbour.facet]) continue;
        seen[neighbour.facet] = true;
        turned[neighbour.facet] = turned[facet] != !neighbour.agrees;
        patch.push_back(neighbour.facet);
      }
    }
    for (const FacetIndex facet : patch) {
      if (turned[facet] == (area_turned > area_kept)) continue;
      std::swap(mesh.facets[facet][1], mesh.facets[facet][2]);
      ++count;
    }
  }
  return count;
}

}  // namespace moldlight
