#include "parting/halves/half_checks.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/facet_encounters.hpp"

namespace moldlight {

GraphTest graph_test(const std::vector<glm::dvec3>& vertices,
                     const std::vector<std::array<SheetVertex, 3>>& facets, double sign) {
  GraphTest test;
  for (const auto& [i, j, k] : facets) {
    const glm::dvec3 &a = vertices[i], &b = vertices[j], &c = vertices[k];
    const double seen = 0.5 * sign * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    (seen < 0.0 ? test.folded : test.covered) += std::abs(seen);
    if (-seen <= test.most) continue;
    test.most = -seen;
    test.place = (a + b + c) / 3.0;
  }
  return test;
}

Needles find_needles(const TriangleMesh& mesh, double thinnest) {
  Needles needles;
  double most = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(mesh.corner(facet, k), mesh.corner(facet, (k + 1) % 3)));
    const double twice_area = glm::length(glm::cross(mesh.corner(facet, 1) - mesh.corner(facet, 0),
                                                     mesh.corner(facet, 2) - mesh.corner(facet, 0)));
    if (twice_area >= thinnest * longest) continue;
    ++needles.count;
    if (longest <= most) continue;
    most = longest;
    needles.place = mesh.corner(facet, 0);
  }
  return needles;
}

std::vector<FacetIndex> crossed_facets(const TriangleMesh& mesh, const Progress& progress) {
  const UnitFrame frame = unit_frame(bounds(mesh));
  std::vector<glm::dvec3> positions;
  for (const glm::dvec3& vertex : mesh.vertices)
    positions.push_back((vertex - frame.center) / frame.diagonal);
  const FacetEncounters met =
      facet_encounters(mesh, positions, facet_geometry(mesh).normals, {}, k_any_crossings, progress);
  std::vector<FacetIndex> crossed;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (!met.crossings.of(facet).empty()) crossed.push_back(facet);
  }
  return crossed;
}

}  // namespace moldlight
