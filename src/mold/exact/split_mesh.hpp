// The part's mesh, split at the borders between regions.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// A triangle of the split mesh: wound as its source facet and inside it.
struct SplitPiece {
  std::array<VertexIndex, 3> corners{};
  FacetIndex facet = 0;  // source
  Region region = Region::both;
};

/// Conforming: neighbours share whole edges, so it is closed if the part is. Pieces are in the order of their
/// facets. The part's own vertices come first, with their numbers and coordinates; lengths are the part's.
struct SplitMesh {
  std::vector<glm::dvec3> vertices;
  std::vector<SplitPiece> pieces;

  [[nodiscard]] const glm::dvec3& corner(std::size_t piece, std::size_t k) const {
    return vertices[pieces[piece].corners[k]];
  }
  [[nodiscard]] glm::dvec3 middle(std::size_t piece) const {
    return (corner(piece, 0) + corner(piece, 1) + corner(piece, 2)) / 3.0;
  }
};
/// The pieces as a mesh of their own: facet k is piece k.
[[nodiscard]] TriangleMesh piece_mesh(const SplitMesh& split);

/// A line between two regions, as far as it has the same two on its sides.
struct RegionBorder {
  Region left = Region::core, right = Region::core;  // left of the walk, seen from outside; left < right
  std::vector<VertexIndex> vertices;                 // of the split mesh; the last is the first if closed
  [[nodiscard]] bool closed() const { return vertices.size() > 2 && vertices.front() == vertices.back(); }
};
/// Every edge of the split mesh whose two pieces are of different regions, chained.
[[nodiscard]] std::vector<RegionBorder> region_borders(const SplitMesh& mesh);

/// Pieces that are looked at one by one, as for the lines between them: some 400 bytes each. Parts have up to
/// four a facet, loose facets that lie over each other dozens. `effort` multiplies them.
[[nodiscard]] inline std::size_t most_pieces(std::size_t facets, double effort) {
  constexpr double k_always = 100'000.0, k_a_facet = 8.0;
  return static_cast<std::size_t>(effort * (k_always + k_a_facet * static_cast<double>(facets)));
}

}  // namespace moldlight
