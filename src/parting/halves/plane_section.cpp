#include "parting/halves/plane_section.hpp"

#include <map>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "parting/halves/plane_mesh.hpp"
#include "parting/halves/sheets.hpp"

namespace moldlight {

std::optional<std::vector<std::array<VertexIndex, 3>>> section_facets(std::span<const glm::dvec3> vertices,
                                                                      std::span<const DirectedEdge> outlines,
                                                                      const WayFrame& frame, double size) {
  const auto in_plane = [&](VertexIndex vertex) { return glm::dvec2(frame.of(vertices[vertex])) / size; };
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const DirectedEdge& edge : outlines) {
    for (const VertexIndex vertex : edge) {
      low = glm::min(low, in_plane(vertex));
      high = glm::max(high, in_plane(vertex));
    }
  }
  const glm::dvec2 middle = 0.5 * (low + high), half = 0.6 * (high - low) + 1e-3;
  PlaneMesh plane(on_grid(-half), on_grid(half));
  std::map<VertexIndex, std::uint32_t> point_of;
  std::map<std::uint32_t, VertexIndex> vertex_of;
  for (const DirectedEdge& edge : outlines) {
    for (const VertexIndex vertex : edge) {
      const auto [entry, added] = point_of.try_emplace(vertex, 0);
      if (!added) continue;
      entry->second = plane.add_point(on_grid(in_plane(vertex) - middle));
      if (!vertex_of.emplace(entry->second, vertex).second) return std::nullopt;
    }
  }
  for (const auto& [from, to] : outlines) {
    if (plane.add_segment(point_of.at(from), point_of.at(to), PlaneMesh::k_outline)) return std::nullopt;
  }
  plane.find_inside();
  std::vector<std::array<VertexIndex, 3>> facets;
  for (const PlaneMesh::Triangle& triangle : plane.triangles()) {
    if (!triangle.inside) continue;
    std::array<VertexIndex, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = vertex_of.find(triangle.corners[k]);
      if (vertex == vertex_of.end()) return std::nullopt;
      corners[k] = vertex->second;
    }
    facets.push_back(corners);
  }
  return facets;
}

}  // namespace moldlight
