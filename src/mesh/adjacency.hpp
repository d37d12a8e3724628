// Half-edge adjacency of a mesh as it comes from files: non-manifold edges, duplicate and flipped facets
// included.
#pragma once

#include <array>
#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Edge e of a facet runs from its corner e to its corner (e + 1) % 3.
struct Adjacency {
  /// Facet across each edge; k_no_facet at an open, non-manifold or inconsistently wound edge and for a
  /// degenerate facet. Symmetric: if g is across an edge of f, then f is across that edge of g.
  std::vector<std::array<FacetIndex, 3>> across;
};

/// Builds the adjacency through OpenMesh half-edges. An edge joins two facets when exactly two facets use it
/// and they run through it in opposite senses; every other edge is cut, and no facet is lost. Throws
/// Cancelled.
[[nodiscard]] Adjacency build_adjacency(const TriangleMesh& mesh, const Progress& progress = Progress());

/// Component (0, 1, …) of each facet, numbered by first facet; facets are connected when they share a vertex
/// pair (any edge, also a non-manifold or inconsistently wound one). Facets with two equal corners get
/// k_no_facet.
struct Components {
  std::vector<FacetIndex> of_facet;
  std::size_t count = 0;
};
[[nodiscard]] Components connected_components(const TriangleMesh& mesh);

}  // namespace moldlight
