#include "parting/piece_edges.hpp"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

namespace moldlight {

PieceEdges piece_edges(const SplitMesh& mesh) {
  struct Use {
    VertexIndex high;
    PieceIndex piece;
    std::uint8_t side;
    bool rises;
  };
  std::vector<std::uint32_t> first(mesh.vertices.size() + 2, 0);
  const auto for_each = [&](const auto& visit) {
    for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece) {
      const auto& corners = mesh.pieces[piece].corners;
      for (std::uint8_t side = 0; side < 3; ++side) {
        const VertexIndex from = corners[side], to = corners[(side + 1U) % 3U];
        visit(std::min(from, to), Use{std::max(from, to), piece, side, from < to});
      }
    }
  };
  for_each([&](VertexIndex low, const Use&) { ++first[low + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Use> uses(first.back());
  for_each([&](VertexIndex low, const Use& use) { uses[first[low + 1]++] = use; });

  PieceEdges result;
  result.of_piece.resize(mesh.pieces.size());
  result.edges.reserve(uses.size() / 2);
  std::vector<Use> rising, falling;
  const auto add = [&](const Use& left, const Use* right) {
    const auto& corners = mesh.pieces[left.piece].corners;
    const auto number = static_cast<std::uint32_t>(result.edges.size());
    PieceEdge edge{.from = corners[left.side],
                   .to = corners[(left.side + 1U) % 3U],
                   .left = left.piece,
                   .left_side = left.side};
    result.of_piece[left.piece][left.side] = number;
    if (right != nullptr) {
      edge.right = right->piece;
      edge.right_side = right->side;
      result.of_piece[right->piece][right->side] = number;
    }
    result.edges.push_back(edge);
  };
  for (VertexIndex low = 0; low < mesh.vertices.size(); ++low) {
    const auto begin = uses.begin() + first[low], end = uses.begin() + first[low + 1];
    std::stable_sort(begin, end, [](const Use& a, const Use& b) { return a.high < b.high; });
    for (auto run = begin, next = begin; run != end; run = next) {
      rising.clear();
      falling.clear();
      for (; next != end && next->high == run->high; ++next)
        (next->rises ? rising : falling).push_back(*next);
      for (std::size_t k = 0; k < std::max(rising.size(), falling.size()); ++k) {
        if (k < rising.size()) {
          add(rising[k], k < falling.size() ? &falling[k] : nullptr);
        } else {
          add(falling[k], nullptr);
        }
      }
    }
  }
  return result;
}

glm::dvec3 twice_piece_area(const SplitMesh& mesh, PieceIndex piece) {
  const auto& corners = mesh.pieces[piece].corners;
  const glm::dvec3& a = mesh.vertices[corners[0]];
  return glm::cross(mesh.vertices[corners[1]] - a, mesh.vertices[corners[2]] - a);
}

}  // namespace moldlight
