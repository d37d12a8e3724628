// Normals and areas of the facets, in double.
#pragma once

#include <vector>

#include <glm/geometric.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// One entry a facet. A facet without area has normal 0 and area 0.
struct FacetGeometry {
  std::vector<glm::dvec3> normals;  // outward unit normals
  std::vector<double> areas;        // model units squared
  double total_area = 0.0;
};

/// Along the outward normal, as long as twice the area.
[[nodiscard]] inline glm::dvec3 twice_area_vector(const TriangleMesh& mesh, FacetIndex facet) {
  const glm::dvec3& a = mesh.corner(facet, 0);
  return glm::cross(mesh.corner(facet, 1) - a, mesh.corner(facet, 2) - a);
}

[[nodiscard]] FacetGeometry facet_geometry(const TriangleMesh& mesh);

/// Sum of the facets' areas as projected along a unit direction.
[[nodiscard]] double projected_area(const FacetGeometry& geometry, const glm::dvec3& direction);

}  // namespace moldlight
