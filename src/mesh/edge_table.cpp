#include "mesh/edge_table.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace moldlight {

EdgeTable::EdgeTable(const TriangleMesh& mesh) : first_use_(mesh.vertices.size() + 1, 0) {
  CHECK(mesh.facets.size() < std::numeric_limits<HalfEdgeIndex>::max() / 3);
  const auto for_each_half_edge = [&mesh](auto&& visit) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      const auto& corners = mesh.facets[facet];
      if (is_collapsed(corners)) continue;
      for (HalfEdgeIndex edge = 0; edge < 3; ++edge) {
        const auto [low, high] = std::minmax(corners[edge], corners[(edge + 1) % 3]);
        visit(low, high, 3 * facet + edge);
      }
    }
  };

  for_each_half_edge([this](VertexIndex low, VertexIndex, HalfEdgeIndex) { ++first_use_[low + 1]; });
  for (std::size_t vertex = 1; vertex < first_use_.size(); ++vertex)
    first_use_[vertex] += first_use_[vertex - 1];

  uses_.resize(first_use_.back());
  std::vector<HalfEdgeIndex> next_free(first_use_.begin(), first_use_.end() - 1);
  for_each_half_edge([&](VertexIndex low, VertexIndex high, HalfEdgeIndex half_edge) {
    uses_[next_free[low]++] = {high, half_edge};
  });

  for (std::size_t low = 0; low + 1 < first_use_.size(); ++low) {
    std::sort(uses_.begin() + first_use_[low], uses_.begin() + first_use_[low + 1],
              [](const EdgeUse& a, const EdgeUse& b) {
                return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
              });
  }
}

}  // namespace moldlight
