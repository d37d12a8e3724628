// How the facets of a mesh hang together as it comes from files, with non-manifold edges, duplicate and
// flipped facets: its edges with the facets that use each, the facets across, and which facets enclose
// something.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Edge e of a facet runs from its corner e to its corner (e + 1) % 3; its number in the mesh is 3 * facet +
/// e.
using HalfEdgeIndex = std::uint32_t;

[[nodiscard]] inline FacetIndex facet_of(HalfEdgeIndex half_edge) { return half_edge / 3; }
[[nodiscard]] inline VertexIndex start_vertex(const TriangleMesh& mesh, HalfEdgeIndex half_edge) {
  return mesh.facets[half_edge / 3][half_edge % 3];
}
[[nodiscard]] inline VertexIndex end_vertex(const TriangleMesh& mesh, HalfEdgeIndex half_edge) {
  return mesh.facets[half_edge / 3][(half_edge % 3 + 1) % 3];
}

/// True when two of the facet's corners are the same vertex; such a facet has no edges.
[[nodiscard]] inline bool is_collapsed(const std::array<VertexIndex, 3>& facet) {
  return facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0];
}

/// One use of an undirected edge by a facet.
struct EdgeUse {
  VertexIndex high = 0;  // the greater of the edge's two vertices
  HalfEdgeIndex half_edge = 0;
};

class EdgeTable {
 public:
  /// Takes 8 bytes a half-edge; collapsed facets are left out.
  explicit EdgeTable(const TriangleMesh& mesh);

  /// Calls visit(low vertex, uses) for each undirected edge, ordered by its vertices; the uses in facet
  /// order.
  template <typename Visit>
  void for_each_edge(Visit&& visit) const {
    for (VertexIndex low = 0; low + 1 < first_use_.size(); ++low) {
      const std::span<const EdgeUse> all(uses_.data() + first_use_[low],
                                         first_use_[low + 1] - first_use_[low]);
      for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        while (end < all.size() && all[end].high == all[begin].high) ++end;
        visit(low, all.subspan(begin, end - begin));
      }
    }
  }

 private:
  std::vector<HalfEdgeIndex> first_use_;  // of each lower vertex; one more at the end
  std::vector<EdgeUse> uses_;
};

/// Edge e of a facet runs from its corner e to its corner (e + 1) % 3.
struct Adjacency {
  /// Facet across each edge; k_no_facet at an open, non-manifold or inconsistently wound edge and for a
  /// degenerate facet. Symmetric: if g is across an edge of f, then f is across that edge of g.
  std::vector<std::array<FacetIndex, 3>> across;
};

/// Builds the adjacency through OpenMesh half-edges. An edge joins two facets when exactly two facets use it
/// and they run through it in opposite senses; every other edge is cut, and no facet is lost. Throws
/// Cancelled.
[[nodiscard]] Adjacency build_adjacency(const TriangleMesh& mesh, const EdgeTable& edges,
                                        const Progress& progress = Progress());
[[nodiscard]] inline Adjacency build_adjacency(const TriangleMesh& mesh) {
  return build_adjacency(mesh, EdgeTable(mesh));
}

/// Component (0, 1, …) of each facet, numbered by first facet; facets are connected when they share a vertex
/// pair (any edge, also a non-manifold or inconsistently wound one). Facets with two equal corners get
/// k_no_facet.
struct Components {
  std::vector<FacetIndex> of_facet;
  std::size_t count = 0;
};
[[nodiscard]] Components connected_components(const TriangleMesh& mesh, const EdgeTable& edges);
[[nodiscard]] inline Components connected_components(const TriangleMesh& mesh) {
  return connected_components(mesh, EdgeTable(mesh));
}

/// True for the facets of bodies without open edges: facets that hang together over edges, each of which they
/// run through as often in the one sense as in the other. An edge may join more than two of them. Collapsed
/// facets enclose nothing and open nothing.
[[nodiscard]] std::vector<bool> solid_facets(const TriangleMesh& mesh, const Adjacency& adjacency);

/// True for the facets of voids without an opening: closed surface of negative volume that hangs together
/// over edges that join two facets. It may touch other surface in an edge.
[[nodiscard]] std::vector<bool> void_facets(const TriangleMesh& mesh, const Adjacency& adjacency);

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
