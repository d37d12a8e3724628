// Normals and areas of the facets, in double.
#pragma once

#include <array>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// One entry a facet. A facet without area has normal 0 and area 0.
struct FacetGeometry {
  std::vector<glm::dvec3> normals;  // outward unit normals
  std::vector<double> areas;        // model units squared
  double total_area = 0.0;
};

/// Along the outward normal, as long as twice the area.
[[nodiscard]] inline glm::dvec3 twice_area_vector(const TriangleMesh& mesh,
                                                  const std::array<VertexIndex, 3>& facet) {
  const glm::dvec3& a = mesh.vertices[facet[0]];
  return glm::cross(mesh.vertices[facet[1]] - a, mesh.vertices[facet[2]] - a);
}
[[nodiscard]] inline glm::dvec3 twice_area_vector(const TriangleMesh& mesh, FacetIndex facet) {
  return twice_area_vector(mesh, mesh.facets[facet]);
}

[[nodiscard]] FacetGeometry facet_geometry(const TriangleMesh& mesh);

/// Sum of the facets' areas as projected along a unit direction.
[[nodiscard]] double projected_area(const FacetGeometry& geometry, const glm::dvec3& direction);

/// Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
[[nodiscard]] inline glm::dvec3 nearest_in_triangle(const glm::dvec3& point,
                                                    const std::array<glm::dvec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 ab = b - a, ac = c - a, ap = point - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const glm::dvec3 bp = point - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const glm::dvec3 cp = point - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
  const double whole = va + vb + vc;
  return whole > 0.0 ? a + vb / whole * ab + vc / whole * ac : a;
}

}  // namespace moldlight
