// Edges between two facets and how they bend.
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Edge from vertex `a` to vertex `b`, in the sense in which `left` runs through it; `right` is the facet
/// across.
struct FacetEdge {
  VertexIndex a = 0, b = 0;
  FacetIndex left = 0, right = 0;
};

/// Bends of less than this many radians count as flat: coordinates in single precision bend flat walls by
/// about 1e-5, and a fine tessellation (a full turn in 10,000 facets) bends by 6e-4.
inline constexpr double k_flat_bend_rad = 1e-4;

/// Edges at which the solid fills more than a half space (reflex, "concave") or less ("convex"), each once,
/// in order of facet and corner. Edges with no facet across or at a facet without area are in neither.
struct BentEdges {
  std::vector<FacetEdge> concave;
  std::vector<FacetEdge> convex;
};
[[nodiscard]] BentEdges bent_edges(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                   const Adjacency& adjacency);

}  // namespace moldlight
