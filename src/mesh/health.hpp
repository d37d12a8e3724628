// The health report: what a part's mesh is like, which figures that puts in doubt, and where it is at fault:
// its open, non-manifold and inconsistently wound edges, strung into chains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Counts of an edge kind are of vertex pairs, not of half-edges; facets with two equal corners have no
/// edges.
struct HealthReport {
  std::size_t facets = 0;
  std::size_t vertices = 0;  // used by at least one facet
  std::size_t components = 0;
  std::size_t open_edges = 0;          // used by one facet
  std::size_t nonmanifold_edges = 0;   // used by three facets or more
  std::size_t inconsistent_edges = 0;  // used by two facets that run through it in the same sense
  std::size_t degenerate_facets = 0;   // two equal corners, or no area
  std::size_t duplicate_facets = 0;    // same three (different) corners as an earlier facet, in any order
  double area = 0.0;                   // model units squared
  double volume = 0.0;                 // model units cubed, signed: negative for an inside-out mesh
  Bounds bounds;

  /// There are edges, and facets run through each as often in the one sense as in the other, so that inside
  /// and outside are defined (non-manifold edges of an even count are allowed).
  bool closed = false;
};

/// Equal vertices of `mesh` must be welded, else its edges count as open; `geometry` is the mesh's own.
[[nodiscard]] HealthReport health_report(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                         const EdgeTable& edges);
[[nodiscard]] inline HealthReport health_report(const TriangleMesh& mesh, const FacetGeometry& geometry) {
  return health_report(mesh, geometry, EdgeTable(mesh));
}

/// Volume that a closed mesh encloses, model units cubed; negative when it is inside out.
[[nodiscard]] double signed_volume(const TriangleMesh& mesh);

/// One sentence for each defect that puts a figure in doubt, and which one; empty for a healthy part.
[[nodiscard]] std::vector<std::string> health_warnings(const HealthReport& report);

/// Kinds of edges as the health report counts them.
enum class EdgeDefect : std::uint8_t { open, nonmanifold, inconsistent };

/// Edges that hang together, end to end. A closed chain runs back from its last vertex to its first and meets
/// no other vertex twice; where chains touch at a vertex they are distinguished there.
struct EdgeChain {
  std::vector<VertexIndex> vertices;  // in order; the first is not repeated at the end
  bool closed = false;
  FacetIndex facet = 0;  // the lowest that has one of the edges
  double length = 0.0;   // model units
  Bounds bounds;

  [[nodiscard]] std::size_t edge_count() const { return vertices.size() - (closed ? 0 : 1); }
};

/// The chains of all edges of one kind, the longest first. A chain of open edges that is closed is the rim of
/// a hole or of a sheet. Equal vertices of `mesh` must be welded.
[[nodiscard]] std::vector<EdgeChain> defect_chains(const TriangleMesh& mesh, EdgeDefect defect);

}  // namespace moldlight
