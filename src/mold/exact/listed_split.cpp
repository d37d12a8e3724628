#include "mold/exact/listed_split.hpp"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "mesh/file_order.hpp"

namespace moldlight {

SplitMesh split_as_listed(const SplitMesh& split, const Part& part) {
  SplitMesh listed;
  listed.vertices.reserve(split.vertices.size());
  listed.pieces.reserve(split.pieces.size());
  std::vector<VertexIndex> number(split.vertices.size());
  std::iota(number.begin(), number.end(), VertexIndex{0});
  for (const VertexIndex vertex : vertices_as_listed(part)) {
    number[vertex] = static_cast<VertexIndex>(listed.vertices.size());
    listed.vertices.push_back(split.vertices[vertex]);
  }
  const auto own = static_cast<std::ptrdiff_t>(listed.vertices.size());
  listed.vertices.insert(listed.vertices.end(), split.vertices.begin() + own, split.vertices.end());
  std::vector<std::uint32_t> starts(part.mesh.facets.size() + 1, 0);  // of each facet's pieces
  for (const SplitPiece& piece : split.pieces) ++starts[piece.facet + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  FacetIndex place = 0;
  for (const FacetIndex facet : facets_as_listed(part)) {
    for (std::uint32_t k = starts[facet]; k < starts[facet + 1]; ++k) {
      SplitPiece piece = split.pieces[k];
      for (VertexIndex& corner : piece.corners) corner = number[corner];
      piece.facet = place;
      listed.pieces.push_back(piece);
    }
    ++place;
  }
  return listed;
}

}  // namespace moldlight
