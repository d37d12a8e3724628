// The mold in all its pieces: the two halves with the slides between them and the lifters in them as solids,
// and what is left to loose inserts. A slide's room is taken out of the halves as that of the part is: as one
// more body between them. A lifter is a straight bar through its half, cut out of it with what it forms.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "actions/side_action.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

/// What forms an insert.
struct InsertActions {
  std::vector<std::size_t> actions;  // numbers in the plan, rising
  std::size_t unreleased = 0;        // undercuts on it that nothing releases; with no action, it is loose
};

/// One an insert: an undercut belongs to the insert that has the most of its corners. `split` is that of the
/// classification that the plan was found for.
[[nodiscard]] std::vector<InsertActions> actions_of_inserts(const MoldHalves& halves, const SplitMesh& split,
                                                            const ActionPlan& plan);

struct MeetingPlace;

/// An action that is no solid of the mold.
struct UnmadeAction {
  std::size_t action = 0;  // number in the plan
  std::string why;         // a clause
};

struct MoldPieces {
  MoldHalves halves;
  std::vector<InsertActions> of_inserts;  // one each of its inserts, slides and lifters among them
  std::vector<UnmadeAction> unmade;       // in the plan's order
};

struct PiecesWish {
  const PartModel& model;
  const MoldHalves& plain;  // without slides
  const ActionPlan& plan;
  const SplitMesh& split;  // of the classification that the plan was found for
  const MeetingPlace& place;
  const MoldSettings& settings;
};
/// The halves with as many of the plan's slides and lifters as can be made; what the others form stays
/// inserts, as in the halves without. Throws Cancelled.
[[nodiscard]] MoldPieces make_pieces(const PiecesWish& wish, const Progress& progress);

}  // namespace moldlight
