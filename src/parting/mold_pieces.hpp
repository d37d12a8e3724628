// The mold in all its pieces: the two halves with the slides between them and the lifters in them as solids,
// and what is left to loose inserts. A slide's room is taken out of the halves as that of the part is: as one
// more body between them. A lifter is a straight bar through its half, cut out of it with what it forms.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "actions/side_action.hpp"
#include "parting/insert_actions.hpp"
#include "parting/mold_halves.hpp"
#include "parting/plain_mold.hpp"

namespace moldlight {

struct MoldPieces {
  MoldHalves halves;
  std::vector<InsertActions> of_inserts;  // one each of its inserts, slides and lifters among them
  std::vector<UnmadeAction> unmade;       // in the plan's order
};

/// The halves with as many of the plan's slides and lifters as can be made; what the others form stays
/// inserts, as in the halves without. Throws Cancelled.
[[nodiscard]] MoldPieces make_pieces(const PiecesWish& wish, const Progress& progress);

}  // namespace moldlight
