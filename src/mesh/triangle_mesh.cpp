#include "mesh/triangle_mesh.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

void Bounds::add(const glm::dvec3& point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

glm::dvec3 Bounds::center() const { return min.x > max.x ? glm::dvec3(0.0) : 0.5 * (min + max); }

double Bounds::diagonal() const { return min.x > max.x ? 0.0 : glm::length(max - min); }

Bounds bounds(const TriangleMesh& mesh) {
  Bounds box;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) box.add(mesh.vertices[vertex]);
  }
  return box;
}

}  // namespace moldlight
