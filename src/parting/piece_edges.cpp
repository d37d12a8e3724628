#include "parting/piece_edges.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/adjacency.hpp"

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

std::vector<std::uint8_t> crease_edges(const SplitMesh& mesh, const PieceEdges& edges,
                                       const FacetGeometry& geometry) {
  const double cosine = std::cos(glm::radians(k_crease_deg));
  std::vector<std::uint8_t> crease;
  crease.reserve(edges.edges.size());
  for (const PieceEdge& edge : edges.edges) {
    const bool open = edge.right == k_no_piece;
    crease.push_back(open || glm::dot(geometry.normals[mesh.pieces[edge.left].facet],
                                      geometry.normals[mesh.pieces[edge.right].facet]) < cosine
                         ? 1
                         : 0);
  }
  return crease;
}

glm::dvec3 twice_piece_area(const SplitMesh& mesh, PieceIndex piece) {
  const auto& corners = mesh.pieces[piece].corners;
  const glm::dvec3& a = mesh.vertices[corners[0]];
  return glm::cross(mesh.vertices[corners[1]] - a, mesh.vertices[corners[2]] - a);
}

void cut_at_height(SplitMesh& mesh, std::vector<std::uint8_t>& free, const HeightCut& cut) {
  std::vector<double> above(mesh.vertices.size());
  for (std::size_t k = 0; k < above.size(); ++k) {
    above[k] = glm::dot(mesh.vertices[k], cut.direction) - cut.height;
    if (std::abs(above[k]) <= cut.tolerance) above[k] = 0.0;
  }
  const auto crosses = [&](VertexIndex a, VertexIndex b) { return above[a] * above[b] < 0.0; };
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middle;
  for (std::size_t piece = 0; piece < mesh.pieces.size(); ++piece) {
    if (free[piece] < cut.least) continue;
    const auto& corners = mesh.pieces[piece].corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex a = corners[k], b = corners[(k + 1) % 3];
      if (!crosses(a, b)) continue;
      const auto [low, high] = std::minmax(a, b);
      const auto [entry, added] =
          middle.try_emplace({low, high}, static_cast<VertexIndex>(mesh.vertices.size()));
      if (!added) continue;
      const double share = above[low] / (above[low] - above[high]);
      mesh.vertices.push_back(mesh.vertices[low] + share * (mesh.vertices[high] - mesh.vertices[low]));
    }
  }
  const auto middle_of = [&](VertexIndex a, VertexIndex b) {
    const auto found = middle.find(std::minmax(a, b));
    return found == middle.end() ? k_no_facet : found->second;
  };
  const std::size_t count = mesh.pieces.size();
  for (std::size_t piece = 0; piece < count; ++piece) {
    const SplitPiece whole = mesh.pieces[piece];
    // A polygon of three to five corners.
    std::vector<VertexIndex> outline;
    for (std::size_t k = 0; k < 3; ++k) {
      outline.push_back(whole.corners[k]);
      const VertexIndex on_side = middle_of(whole.corners[k], whole.corners[(k + 1) % 3]);
      if (on_side != k_no_facet) outline.push_back(on_side);
    }
    if (outline.size() == 3) continue;
    // A fan from the new vertex runs along the cut where the other new one is the next but one.
    const auto is_new = [&](std::size_t k) { return outline[k] >= above.size(); };
    while (!is_new(0) || (outline.size() == 5 && !is_new(2)))
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
      SplitPiece part = whole;
      part.corners = {outline[0], outline[k], outline[k + 1]};
      if (k == 1) {
        mesh.pieces[piece] = part;
      } else {
        mesh.pieces.push_back(part);
        free.push_back(free[piece]);
      }
    }
  }
}

}  // namespace moldlight
