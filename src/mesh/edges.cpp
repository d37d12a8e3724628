#include "mesh/edges.hpp"

#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr std::size_t next(std::size_t corner) { return (corner + 1) % 3; }

/// Corner of `facet` at which its edge to vertex `to` starts from `from`; 3 if it has none.
std::size_t edge_corner(const std::array<VertexIndex, 3>& facet, VertexIndex from, VertexIndex to) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (facet[corner] == from && facet[next(corner)] == to) return corner;
  }
  return 3;
}

double corner_angle(const TriangleMesh& mesh, FacetIndex facet, std::size_t corner) {
  const auto& vertices = mesh.facets[facet];
  const glm::dvec3 one = mesh.vertices[vertices[next(corner)]] - mesh.vertices[vertices[corner]];
  const glm::dvec3 other = mesh.vertices[vertices[next(next(corner))]] - mesh.vertices[vertices[corner]];
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

}  // namespace

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

SmoothCorners smooth_corners(const TriangleMesh& mesh, const FacetGeometry& geometry,
                             const Adjacency& adjacency, double crease_deg) {
  const double threshold = std::cos(glm::radians(crease_deg));
  const std::size_t facets = mesh.facets.size();
  UnionFind corners(3 * facets);
  const auto number = [](FacetIndex facet, std::size_t corner) {
    return static_cast<std::uint32_t>(3 * facet + corner);
  };
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][corner];
      if (across == k_no_facet || across < facet) continue;
      if (glm::dot(geometry.normals[facet], geometry.normals[across]) < threshold) continue;
      const VertexIndex a = mesh.facets[facet][corner], b = mesh.facets[facet][next(corner)];
      const std::size_t back = edge_corner(mesh.facets[across], b, a);
      if (back == 3) continue;
      corners.join(number(facet, corner), number(across, next(back)));
      corners.join(number(facet, next(corner)), number(across, back));
    }
  }

  SmoothCorners smooth;
  smooth.of_facet.resize(facets);
  std::vector<glm::dvec3> sums;
  std::vector<VertexIndex> split(3 * facets);
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t own = number(facet, corner), first = corners.find(own);
      // The lowest corner stands for its set, so it is met first.
      if (first == own) {
        split[own] = static_cast<VertexIndex>(smooth.source.size());
        smooth.source.push_back(mesh.facets[facet][corner]);
        sums.emplace_back(0.0);
      }
      const VertexIndex vertex = split[first];
      smooth.of_facet[facet][corner] = vertex;
      // Weights by area keep large planes plane: their neighbours in a fillet take the bend.
      sums[vertex] += geometry.areas[facet] * corner_angle(mesh, facet, corner) * geometry.normals[facet];
    }
  }
  smooth.normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    smooth.normals.push_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0F, 0.0F, 1.0F));
  }
  return smooth;
}

std::vector<EdgeEnds> crease_edges(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                   const Adjacency& adjacency, double crease_deg) {
  const double threshold = std::cos(glm::radians(crease_deg));
  std::vector<EdgeEnds> edges;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (geometry.areas[facet] <= 0.0) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][corner];
      if (across != k_no_facet) {
        if (across < facet || geometry.areas[across] <= 0.0) continue;
        if (glm::dot(geometry.normals[facet], geometry.normals[across]) >= threshold) continue;
      }
      edges.push_back({mesh.facets[facet][corner], mesh.facets[facet][next(corner)]});
    }
  }
  return edges;
}

}  // namespace moldlight
