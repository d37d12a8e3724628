#include "mesh/edge_collapse.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"

namespace moldlight {

namespace {

using Corners = std::array<VertexIndex, 3>;

bool has(const Corners& facet, VertexIndex vertex) { return std::ranges::find(facet, vertex) != facet.end(); }

double longest_side(const TriangleMesh& mesh, const Corners& facet) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, glm::distance(mesh.vertices[facet[k]], mesh.vertices[facet[(k + 1) % 3]]));
  return longest;
}

/// Whether a facet that is wider than `length` would turn over.
bool turns_over(const TriangleMesh& mesh, const EdgeCollapse& edges, VertexIndex from, VertexIndex to,
                double length) {
  return std::ranges::any_of(edges.around(from), [&](FacetIndex facet) {
    const Corners before = mesh.facets[facet];
    if (has(before, to)) return false;
    Corners after = before;
    std::ranges::replace(after, from, to);
    const glm::dvec3 area = twice_area_vector(mesh, before);
    return glm::length(area) > length * longest_side(mesh, before) &&
           glm::dot(area, twice_area_vector(mesh, after)) <= 0.0;
  });
}

}  // namespace

EdgeCollapse::EdgeCollapse(TriangleMesh& mesh)
    : mesh_(mesh), gone_(mesh.facets.size(), 0), around_(mesh.vertices.size()) {
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (const VertexIndex corner : mesh.facets[facet]) around_[corner].push_back(facet);
  }
}

std::vector<VertexIndex> EdgeCollapse::corners_around(VertexIndex vertex) const {
  std::vector<VertexIndex> found;
  for (const FacetIndex facet : around_[vertex]) {
    for (const VertexIndex corner : mesh_.facets[facet]) found.push_back(corner);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool EdgeCollapse::keeps_edges(VertexIndex from, VertexIndex to) const {
  const auto has_other = [&](FacetIndex facet) { return has(mesh_.facets[facet], to); };
  if (std::ranges::count_if(around_[from], has_other) != 2) return false;
  const std::vector<VertexIndex> beside_from = corners_around(from), beside_to = corners_around(to);
  std::vector<VertexIndex> common;
  std::ranges::set_intersection(beside_from, beside_to, std::back_inserter(common));
  return common.size() == 4;  // both ends and the tips of their two facets
}

void EdgeCollapse::join(VertexIndex from, VertexIndex to) {
  for (const FacetIndex facet : around_[from]) {
    if (has(mesh_.facets[facet], to)) {
      gone_[facet] = 1;
      for (const VertexIndex corner : mesh_.facets[facet]) {
        if (corner != from) std::erase(around_[corner], facet);
      }
    } else {
      std::ranges::replace(mesh_.facets[facet], from, to);
      around_[to].push_back(facet);
    }
  }
  around_[from].clear();
}

void EdgeCollapse::finish() {
  std::size_t kept = 0;
  for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
    if (!is_gone(facet)) mesh_.facets[kept++] = mesh_.facets[facet];
  }
  mesh_.facets.resize(kept);
}

void collapse_short_edges(TriangleMesh& mesh, double length) {
  // Those that come up by what goes are of the next round.
  for (bool any = true; any;) {
    any = false;
    std::vector<std::pair<double, std::array<VertexIndex, 2>>> shorts;
    EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
      const double its = glm::distance(mesh.vertices[low], mesh.vertices[uses[0].high]);
      if (its < length) shorts.push_back({its, {low, uses[0].high}});
    });
    std::ranges::sort(shorts);
    EdgeCollapse edges(mesh);
    for (const auto& [its, ends] : shorts) {
      const auto [to, from] = ends;
      if (!edges.keeps_edges(from, to) || turns_over(mesh, edges, from, to, length)) continue;
      edges.join(from, to);
      any = true;
    }
    edges.finish();
  }
}

}  // namespace moldlight
