// Edges between two facets and how they bend; creases, which bend by more than an angle, and normals that are
// smooth up to them.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

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

/// Below this bend, in degrees, two facets are taken for one smooth surface.
inline constexpr double k_crease_deg = 30.0;

/// The mesh's corners with equal ones joined: vertices are split along creases.
struct SmoothCorners {
  std::vector<VertexIndex> source;                   // vertex of the mesh that each split vertex is
  std::vector<glm::vec3> normals;                    // unit; of split vertices, weighted by area and angle
  std::vector<std::array<VertexIndex, 3>> of_facet;  // split vertices of each facet's corners
};
[[nodiscard]] SmoothCorners smooth_corners(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                           const Adjacency& adjacency, double crease_deg = k_crease_deg);

/// Ends of an edge.
struct EdgeEnds {
  VertexIndex a = 0, b = 0;
};
/// Edges that bend by more than `crease_deg` and edges with no facet across, in order of facet and corner.
[[nodiscard]] std::vector<EdgeEnds> crease_edges(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                                 const Adjacency& adjacency,
                                                 double crease_deg = k_crease_deg);

}  // namespace moldlight
