#include "mold/exact/split_mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

namespace moldlight {

namespace {

/// An edge between two regions, run through by the piece on its left.
struct BorderEdge {
  VertexIndex from, to;
  Region left, right;
};

struct EdgeOfPiece {
  VertexIndex high;
  bool rises;  // the piece runs from the lower vertex to the higher
  Region region;
};

/// Edges of pieces by their lower vertex.
std::vector<BorderEdge> border_edges(const SplitMesh& mesh) {
  std::vector<std::uint32_t> first(mesh.vertices.size() + 2, 0);
  const auto for_each_edge = [&](const auto& visit) {
    for (const SplitPiece& piece : mesh.pieces) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex from = piece.corners[k], to = piece.corners[(k + 1) % 3];
        visit(std::min(from, to), EdgeOfPiece{std::max(from, to), from < to, piece.region});
      }
    }
  };
  for_each_edge([&](VertexIndex low, const EdgeOfPiece&) { ++first[low + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<EdgeOfPiece> edges(first.back());
  for_each_edge([&](VertexIndex low, const EdgeOfPiece& edge) { edges[first[low + 1]++] = edge; });

  std::vector<BorderEdge> borders;
  for (VertexIndex low = 0; low < mesh.vertices.size(); ++low) {
    const auto begin = edges.begin() + first[low], end = edges.begin() + first[low + 1];
    std::stable_sort(begin, end, [](const EdgeOfPiece& a, const EdgeOfPiece& b) { return a.high < b.high; });
    for (auto run = begin, next = begin; run != end; run = next) {
      while (next != end && next->high == run->high) ++next;
      // Pairs of opposite senses, in order: one pair at an edge of a manifold.
      std::vector<Region> rising, falling;
      for (auto edge = run; edge != next; ++edge) (edge->rises ? rising : falling).push_back(edge->region);
      for (std::size_t k = 0; k < std::min(rising.size(), falling.size()); ++k) {
        if (rising[k] < falling[k]) borders.push_back({low, run->high, rising[k], falling[k]});
        if (falling[k] < rising[k]) borders.push_back({run->high, low, falling[k], rising[k]});
      }
    }
  }
  return borders;
}

}  // namespace

TriangleMesh piece_mesh(const SplitMesh& split) {
  TriangleMesh mesh{.vertices = split.vertices, .facets = {}};
  mesh.facets.reserve(split.pieces.size());
  for (const SplitPiece& piece : split.pieces) mesh.facets.push_back(piece.corners);
  return mesh;
}

std::vector<RegionBorder> region_borders(const SplitMesh& mesh) {
  std::vector<BorderEdge> edges = border_edges(mesh);
  const auto key = [](const BorderEdge& edge) {
    return std::tuple(edge.left, edge.right, edge.from, edge.to);
  };
  std::ranges::sort(edges, {}, key);
  std::vector<RegionBorder> borders;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    const Region left = edges[begin].left, right = edges[begin].right;
    while (end < edges.size() && edges[end].left == left && edges[end].right == right) ++end;
    const std::span<const BorderEdge> same(edges.data() + begin, end - begin);
    std::map<VertexIndex, int> into;
    for (const BorderEdge& edge : same) ++into[edge.to];
    const auto out_of = [&](VertexIndex vertex) {
      const auto range =
          std::equal_range(same.begin(), same.end(), BorderEdge{vertex, 0, left, right},
                           [](const BorderEdge& a, const BorderEdge& b) { return a.from < b.from; });
      return std::span(range.first, range.second);
    };
    const auto passes = [&](VertexIndex vertex) {
      const auto found = into.find(vertex);
      return found != into.end() && found->second == 1 && out_of(vertex).size() == 1;
    };
    std::vector<bool> used(same.size(), false);
    const auto walk = [&](std::size_t start) {
      RegionBorder border{.left = left, .right = right, .vertices = {same[start].from}};
      for (std::size_t k = start; !used[k];) {
        used[k] = true;
        border.vertices.push_back(same[k].to);
        if (!passes(same[k].to)) break;
        k = static_cast<std::size_t>(&out_of(same[k].to).front() - same.data());
      }
      borders.push_back(std::move(border));
    };
    for (std::size_t k = 0; k < same.size(); ++k) {
      if (!used[k] && !passes(same[k].from)) walk(k);
    }
    for (std::size_t k = 0; k < same.size(); ++k) {
      if (!used[k]) walk(k);
    }
  }
  return borders;
}

}  // namespace moldlight
