// Surface that a half sees only through a hole, across the room of an action that forms what is around it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "parting/piece_edges.hpp"

namespace moldlight {

struct SeenThrough {
  const PartModel& model;
  const SplitMesh& mesh;
  const PieceEdges& edges;
  const std::vector<std::uint8_t>& crease;  // one an edge
  const std::vector<std::uint8_t>& former;  // of each piece: whose it is so far
  std::uint8_t action = 0;                  // of these, the action's
  glm::dvec3 direction{0, 0, 1};            // unit
  double lateral = 0.0;                     // the lateral tolerance, in diagonals: walls lean by facets
};
/// Pieces that are rather the action's: a patch on a wall that the action forms around it, under a roof that
/// it forms, too, and with the wall free along one way across the direction. A half would reach it with a
/// pin that stands in the way of the slide.
struct SeenPatch {
  std::vector<PieceIndex> pieces;
  glm::dvec3 way{1, 0, 0};  // unit
};
/// Throws Cancelled.
[[nodiscard]] std::vector<SeenPatch> seen_through(const SeenThrough& wish, const Progress& progress);

}  // namespace moldlight
