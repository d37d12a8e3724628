#include "mesh/facet_geometry.hpp"

#include <glm/geometric.hpp>

namespace moldlight {

FacetGeometry facet_geometry(const TriangleMesh& mesh) {
  FacetGeometry geometry;
  geometry.normals.reserve(mesh.facets.size());
  geometry.areas.reserve(mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3& a = mesh.corner(facet, 0);
    const glm::dvec3 twice_area_normal = glm::cross(mesh.corner(facet, 1) - a, mesh.corner(facet, 2) - a);
    const double twice_area = glm::length(twice_area_normal);
    geometry.normals.push_back(twice_area > 0.0 ? twice_area_normal / twice_area : glm::dvec3(0.0));
    geometry.areas.push_back(0.5 * twice_area);
    geometry.total_area += 0.5 * twice_area;
  }
  return geometry;
}

}  // namespace moldlight
