#include "mesh/solids.hpp"

#include <algorithm>
#include <tuple>

#include "mesh/edge_table.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

std::vector<bool> solid_facets(const TriangleMesh& mesh, const Adjacency& adjacency) {
  const std::size_t count = mesh.facets.size();
  UnionFind bodies(count);
  // Edges that do not join just two facets, by their vertices.
  struct Use {
    VertexIndex low, high;
    FacetIndex facet;
    int sense;
  };
  std::vector<Use> uses;
  for (FacetIndex facet = 0; facet < count; ++facet) {
    const auto& corners = mesh.facets[facet];
    if (is_collapsed(corners)) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][corner];
      if (across != k_no_facet) {
        bodies.join(facet, across);
        continue;
      }
      const VertexIndex from = corners[corner], to = corners[(corner + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), facet, from < to ? 1 : -1});
    }
  }
  std::ranges::sort(uses, {}, [](const Use& use) { return std::tuple(use.low, use.high, use.facet); });
  std::vector<FacetIndex> open;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    int balance = 0;
    for (; end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high;
         ++end) {
      balance += uses[end].sense;
      bodies.join(uses[begin].facet, uses[end].facet);
    }
    if (balance != 0) open.push_back(uses[begin].facet);
  }
  std::vector<bool> solid_body(count, true), solid(count);
  for (const FacetIndex facet : open) solid_body[bodies.find(facet)] = false;
  for (FacetIndex facet = 0; facet < count; ++facet) solid[facet] = solid_body[bodies.find(facet)];
  return solid;
}

}  // namespace moldlight
