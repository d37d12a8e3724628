#include "render/view_body.hpp"

#include <glm/geometric.hpp>

namespace moldlight {

ViewBody view_body(const TriangleMesh& mesh, const UnitFrame& frame, Colour colour) {
  ViewBody body;
  body.colour = colour;
  for (const auto& [a, b, c] : mesh.facets) {
    const glm::dvec3 normal =
        glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    const double length = glm::length(normal);
    if (length <= 0.0) continue;
    const auto first = static_cast<VertexIndex>(body.vertices.size());
    body.facets.push_back({first, first + 1, first + 2});
    for (const VertexIndex vertex : {a, b, c})
      body.vertices.push_back({frame.to_unit(mesh.vertices[vertex]), octahedral(glm::vec3(normal / length))});
  }
  return body;
}

}  // namespace moldlight
