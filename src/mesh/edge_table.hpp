// The undirected edges of a mesh and the facets that use each, grouped by a counting sort over the lower
// vertex.
#pragma once

#include <span>
#include <vector>

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

}  // namespace moldlight
