// Thin walls, whose two faces no half should form alone: its steel would have a slot as narrow and deep.
#pragma once

#include <cstdint>
#include <vector>

#include "classify/part_model.hpp"
#include "parting/piece_edges.hpp"

namespace moldlight {

/// A place of a piece that either half could form, with the piece behind it.
struct ThinWall {
  PieceIndex piece = 0, other = 0;
  double cost = 0.0;  // a length: where one half forms both
};
/// By some rays from each piece that is `free` (not 0, one a piece).
[[nodiscard]] std::vector<ThinWall> thin_walls(const PartModel& model, const SplitMesh& mesh,
                                               const std::vector<std::uint8_t>& free);

}  // namespace moldlight
