// Edges of a closed mesh that shrink to one of their ends.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// One edge at a time. The mesh, which outlives it, has its facets but for those that are gone after
/// finish().
class EdgeCollapse {
 public:
  explicit EdgeCollapse(TriangleMesh& mesh);

  /// Facets at a vertex; none once it has gone to another.
  [[nodiscard]] const std::vector<FacetIndex>& around(VertexIndex vertex) const { return around_[vertex]; }
  [[nodiscard]] bool is_gone(FacetIndex facet) const { return gone_[facet] != 0; }
  /// Whether the edge between them is of two facets, and no other edge would get more than two.
  [[nodiscard]] bool keeps_edges(VertexIndex from, VertexIndex to) const;
  /// `from` goes to where `to` is, and the facets that have both are gone.
  void join(VertexIndex from, VertexIndex to);
  void finish();

 private:
  [[nodiscard]] std::vector<VertexIndex> corners_around(VertexIndex vertex) const;

  TriangleMesh& mesh_;
  std::vector<std::uint8_t> gone_;
  std::vector<std::vector<FacetIndex>> around_;
};

/// Edges that are shorter than `length` go, where the mesh hangs together as before and no facet that is
/// wider than that turns over: no face of it has sides that other programs take for points.
void collapse_short_edges(TriangleMesh& mesh, double length);

}  // namespace moldlight
