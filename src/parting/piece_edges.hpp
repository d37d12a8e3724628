// The edges of a split mesh and the two pieces at each.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/exact/split_mesh.hpp"

namespace moldlight {

using PieceIndex = std::uint32_t;
inline constexpr PieceIndex k_no_piece = ~0U;

/// Runs from `from` to `to` as `left` does; the piece on its right runs the other way.
struct PieceEdge {
  VertexIndex from = 0, to = 0;
  PieceIndex left = 0, right = k_no_piece;     // right: none at an open edge
  std::uint8_t left_side = 0, right_side = 0;  // side k of a piece runs from corner k to corner k + 1
};

struct PieceEdges {
  std::vector<PieceEdge> edges;                        // each once
  std::vector<std::array<std::uint32_t, 3>> of_piece;  // number of the edge at each side

  [[nodiscard]] PieceIndex across(PieceIndex piece, std::size_t side) const {
    const PieceEdge& edge = edges[of_piece[piece][side]];
    return edge.left == piece && edge.left_side == side ? edge.right : edge.left;
  }
  /// Side of the piece across.
  [[nodiscard]] std::size_t side_across(PieceIndex piece, std::size_t side) const {
    const PieceEdge& edge = edges[of_piece[piece][side]];
    return edge.left == piece && edge.left_side == side ? edge.right_side : edge.left_side;
  }
};

/// Where more than two pieces meet, those of opposite senses are paired in the order of their numbers.
[[nodiscard]] PieceEdges piece_edges(const SplitMesh& mesh);

/// Along the outward normal, as long as twice the area.
[[nodiscard]] glm::dvec3 twice_piece_area(const SplitMesh& mesh, PieceIndex piece);

}  // namespace moldlight
