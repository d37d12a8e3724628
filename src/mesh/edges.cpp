#include "mesh/edges.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace moldlight {

BentEdges bent_edges(const TriangleMesh& mesh, const FacetGeometry& geometry, const Adjacency& adjacency) {
  BentEdges edges;
  for (FacetIndex left = 0; left < mesh.facets.size(); ++left) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex right = adjacency.across[left][corner];
      if (right == k_no_facet || right < left) continue;
      if (geometry.areas[left] <= 0.0 || geometry.areas[right] <= 0.0) continue;
      const VertexIndex a = mesh.facets[left][corner];
      const VertexIndex b = mesh.facets[left][(corner + 1) % 3];
      const glm::dvec3 along = mesh.vertices[b] - mesh.vertices[a];
      // Positive where the right facet turns down from the left one's plane: less than a half space of solid.
      const double bend = glm::dot(glm::cross(geometry.normals[left], geometry.normals[right]), along);
      const double threshold = k_flat_bend_rad * glm::length(along);
      if (bend > threshold) edges.convex.push_back({a, b, left, right});
      if (bend < -threshold) edges.concave.push_back({a, b, left, right});
    }
  }
  return edges;
}

}  // namespace moldlight
