// The edges of a split mesh and the two pieces at each.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/facet_geometry.hpp"
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

/// Which of them a line likes to run along: those that bend by more than k_crease_deg, and open ones.
[[nodiscard]] std::vector<std::uint8_t> crease_edges(const SplitMesh& mesh, const PieceEdges& edges,
                                                     const FacetGeometry& geometry);

/// What a line along creases costs, of one across a face.
inline constexpr double k_crease_weight = 0.5;
/// A wall with 1 degree of reverse draft, a fifth of the diagonal wide, costs as much as two climbs along it.
inline constexpr double k_draft_weight = 2300.0;
/// Reverse draft below this is rounding.
inline constexpr double k_least_reverse_sine = 1e-5;

/// Along the outward normal, as long as twice the area.
[[nodiscard]] glm::dvec3 twice_piece_area(const SplitMesh& mesh, PieceIndex piece);

/// Along `direction` (unit), in the part's coordinates; ends nearer than `tolerance` are not cut off.
struct HeightCut {
  glm::dvec3 direction{0, 0, 1};
  double height = 0.0;
  double tolerance = 0.0;
  std::uint8_t least = 1;  // of `free`, of what is cut
};

/// The mesh stays conforming: neighbours of what is cut are cut at the shared edges. `free` is kept one entry
/// a piece.
void cut_at_height(SplitMesh& mesh, std::vector<std::uint8_t>& free, const HeightCut& cut);

/// Of a straight piece: its length, and three times as much for what of it climbs along the unit direction.
[[nodiscard]] inline double line_cost(const glm::dvec3& piece, const glm::dvec3& direction) {
  constexpr double k_climb_weight = 3.0;
  return glm::length(piece) + k_climb_weight * std::abs(glm::dot(piece, direction));
}

}  // namespace moldlight
