#include "mesh/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

void Bounds::add(const glm::dvec3& point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

glm::dvec3 Bounds::center() const { return min.x > max.x ? glm::dvec3(0.0) : 0.5 * (min + max); }

double Bounds::diagonal() const { return min.x > max.x ? 0.0 : glm::length(max - min); }

std::array<glm::dvec3, 8> Bounds::corners() const {
  std::array<glm::dvec3, 8> corners{};
  for (std::size_t k = 0; k < corners.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) corners[k][axis] = (k >> axis & 1U) != 0 ? max[axis] : min[axis];
  return corners;
}

double rounding_step(const TriangleMesh& mesh) {
  double most = 0.0;
  for (const glm::dvec3& v : mesh.vertices)
    most = std::max({most, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return most * 0x1p-23;
}

Bounds bounds(const TriangleMesh& mesh) {
  Bounds box;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) box.add(mesh.vertices[vertex]);
  }
  return box;
}

void append(const TriangleMesh& solid, TriangleMesh& mesh) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), solid.vertices.begin(), solid.vertices.end());
  for (const auto& [a, b, c] : solid.facets) mesh.facets.push_back({a + first, b + first, c + first});
}

}  // namespace moldlight
