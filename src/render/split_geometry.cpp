#include "render/split_geometry.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr std::uint32_t k_bits_shift = 30;
constexpr float k_least_square = 1e-6F;  // of a mean normal; one shorter says nothing

std::uint32_t accessibility_bits(Region region) {
  switch (region) {
    case Region::core:
      return 1;
    case Region::cavity:
      return 2;
    case Region::both:
      return 3;
    case Region::undercut:
      break;
  }
  return 0;
}

/// Shares of a facet's corners in a point of it, sum 1; those of the first corner alone for a facet without
/// area.
glm::dvec3 corner_weights(const TriangleMesh& mesh, FacetIndex facet, const glm::dvec3& point) {
  const glm::dvec3& origin = mesh.corner(facet, 0);
  const glm::dvec3 to_1 = mesh.corner(facet, 1) - origin, to_2 = mesh.corner(facet, 2) - origin;
  const glm::dvec3 normal = glm::cross(to_1, to_2), at = point - origin;
  const double square = glm::dot(normal, normal);
  if (!(square > 0.0)) return {1.0, 0.0, 0.0};
  const double second = glm::dot(glm::cross(at, to_2), normal) / square;
  const double third = glm::dot(glm::cross(to_1, at), normal) / square;
  return {1.0 - second - third, second, third};
}

}  // namespace

SplitGeometry split_geometry(const SplitMesh& split, const TriangleMesh& mesh, const ViewGeometry& view,
                             const UnitFrame& frame) {
  CHECK(mesh.facets.size() < std::size_t{1} << k_bits_shift);
  SplitGeometry geometry;
  geometry.vertices.reserve(view.vertices.size() + 2 * (split.vertices.size() - mesh.vertices.size()));
  geometry.vertices = view.vertices;
  geometry.pieces.reserve(split.pieces.size());
  geometry.sources.reserve(split.pieces.size());
  // Of each vertex of the split mesh that is no corner of the facet at hand: the last facet that used it, and
  // its copy for that.
  struct Copy {
    FacetIndex facet = k_no_facet;
    VertexIndex vertex = 0;
  };
  std::vector<Copy> copies(split.vertices.size());
  const auto cut_vertex = [&](FacetIndex facet, VertexIndex number) {
    Copy& copy = copies[number];
    if (copy.facet != facet) {
      copy = {facet, static_cast<VertexIndex>(geometry.vertices.size())};
      const glm::dvec3 weights = corner_weights(mesh, facet, split.vertices[number]);
      glm::vec3 normal(0.0F);
      for (int k = 0; k < 3; ++k) {
        const VertexIndex corner = view.facets[facet][static_cast<std::size_t>(k)];
        normal += static_cast<float>(weights[k]) * from_octahedral(view.vertices[corner].normal);
      }
      const ViewVertex& first = view.vertices[view.facets[facet][0]];
      geometry.vertices.push_back(
          {frame.to_unit(split.vertices[number]),
           glm::dot(normal, normal) > k_least_square ? octahedral(normal) : first.normal});
    }
    return copy.vertex;
  };
  for (const SplitPiece& piece : split.pieces) {
    const auto& whole = mesh.facets[piece.facet];
    std::array<VertexIndex, 3> corners = view.facets[piece.facet];
    if (piece.corners != whole) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto* corner = std::find(whole.begin(), whole.end(), piece.corners[k]);
        corners[k] = corner != whole.end()
                         ? view.facets[piece.facet][static_cast<std::size_t>(corner - whole.begin())]
                         : cut_vertex(piece.facet, piece.corners[k]);
      }
    }
    geometry.pieces.push_back(corners);
    geometry.sources.push_back(piece.facet | accessibility_bits(piece.region) << k_bits_shift);
  }
  return geometry;
}

}  // namespace moldlight
