#include "mesh/facet_geometry.hpp"

#include <cmath>

namespace moldlight {

FacetGeometry facet_geometry(const TriangleMesh& mesh) {
  FacetGeometry geometry;
  geometry.normals.reserve(mesh.facets.size());
  geometry.areas.reserve(mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 vector = twice_area_vector(mesh, facet);
    const double twice_area = glm::length(vector);
    geometry.normals.push_back(twice_area > 0.0 ? vector / twice_area : glm::dvec3(0.0));
    geometry.areas.push_back(0.5 * twice_area);
    geometry.total_area += 0.5 * twice_area;
  }
  return geometry;
}

double projected_area(const FacetGeometry& geometry, const glm::dvec3& direction) {
  double projected = 0.0;
  for (std::size_t facet = 0; facet < geometry.areas.size(); ++facet) {
    projected += geometry.areas[facet] * std::abs(glm::dot(geometry.normals[facet], direction));
  }
  return projected;
}

}  // namespace moldlight
