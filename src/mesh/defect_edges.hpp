// Where a mesh is at fault: its open, non-manifold and inconsistently wound edges, strung into chains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

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
