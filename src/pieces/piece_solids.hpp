// The pieces of a mold as solids: the certified halves of an opposite pair of directions, and the bodies that
// they leave between them, each pulled along another direction once the halves are gone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "parting/mold_halves.hpp"
#include "pieces/find_pieces.hpp"

namespace moldlight {

/// A body of the mold.
struct PieceSolid {
  std::optional<std::size_t> direction;  // number of it; none: no direction releases the body
  double travel = 0.0;                   // until it is clear of the part, in the part's unit
  std::size_t sequence = 0;              // when it is removed, the halves first, at 1; 0: it stays
};

struct PieceSolids {
  std::string refusal;                   // why there are none, a clause; empty where there are
  std::optional<glm::dvec3> refused_at;  // in the part's coordinates
  /// Those that were found and, where none of them are opposite to each other, the opposite of one. Unit.
  std::vector<glm::dvec3> directions;
  /// Its written bodies are the mold's, named "piece_1", "piece_3_2" in the order of removal, and "left_1"
  /// for what no direction releases.
  MoldHalves halves;
  std::vector<PieceSolid> solids;  // one each of the written bodies; empty where there are none
};

/// Directions of which one may be that of the halves: the first of an opposite pair, else all of them.
[[nodiscard]] std::vector<std::size_t> halves_directions(const PiecesResult& result);

/// `halves` are those along the direction of this number, whatever the undercut. What no single direction
/// releases between them is divided by planes (divided_body). Refused where one of the bodies is not closed,
/// crosses itself, or hits the part or a body that is removed later by more than the lateral tolerance, on
/// some 20,000 lines along its way. Bodies that nothing releases may stay if their surface is no more than
/// twice what the settings leave over. Throws Cancelled.
[[nodiscard]] PieceSolids piece_solids(const PartModel& model, const PiecesResult& result, std::size_t along,
                                       MoldHalves halves, const Progress& progress);

}  // namespace moldlight
