#include "render/view_body.hpp"

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/edges.hpp"
#include "mesh/facet_geometry.hpp"

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

ViewSolid view_solid(const TriangleMesh& mesh, const UnitFrame& frame, Steel steel) {
  ViewSolid solid{.body = view_body(mesh, frame, {}), .steel = steel, .edges = {}};
  for (const EdgeEnds& edge : crease_edges(mesh, facet_geometry(mesh), build_adjacency(mesh)))
    solid.edges.push_back({frame.to_unit(mesh.vertices[edge.a]), frame.to_unit(mesh.vertices[edge.b])});
  return solid;
}

}  // namespace moldlight
