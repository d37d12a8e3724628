#include "parting/hull/half_checks.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/union_find.hpp"
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

SurfaceFigures surface_figures(const Sheets& sheets, double slope_deg, double narrow, double tolerance) {
  SurfaceFigures figures;
  constexpr double k_rounding_deg = 0.01;
  // A shut-off hangs together without the block's rim.
  UnionFind joined(sheets.vertices.size());
  glm::dvec2 low(INFINITY);
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    joined.join(facet.corners[0], facet.corners[1]);
    joined.join(facet.corners[1], facet.corners[2]);
  }
  std::uint32_t rim = 0;
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    for (const SheetVertex v : facet.corners) {
      const glm::dvec2 at(sheets.vertices[v]);
      if (at.x + at.y < low.x + low.y) {
        low = at;
        rim = v;
      }
    }
  }
  double steepest = 0.0;
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    const glm::dvec3 normal =
        glm::cross(sheets.vertices[facet.corners[1]] - sheets.vertices[facet.corners[0]],
                   sheets.vertices[facet.corners[2]] - sheets.vertices[facet.corners[0]]);
    const double area = 0.5 * glm::length(normal);
    (joined.find(facet.corners[0]) == joined.find(rim) ? figures.parting_area : figures.shut_off_area) +=
        area;
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(glm::dvec2(sheets.vertices[facet.corners[k]]),
                                                glm::dvec2(sheets.vertices[facet.corners[(k + 1) % 3]])));
    if (normal.z <= narrow * longest) continue;
    const double tangent = glm::length(glm::dvec2(normal)) / normal.z;
    const double slope = std::atan(std::max(tangent - 2.0 * tolerance * longest / normal.z, 0.0));
    steepest = std::max(steepest, slope);
    if (glm::degrees(slope) > slope_deg + k_rounding_deg) figures.too_steep_area += area;
  }
  figures.steepest_deg = glm::degrees(steepest);
  return figures;
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
  const FacetEncounters met = facet_encounters(mesh, positions, facet_geometry(mesh).normals, progress);
  std::vector<FacetIndex> crossed;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (!met.crossings.of(facet).empty()) crossed.push_back(facet);
  }
  return crossed;
}

}  // namespace moldlight
