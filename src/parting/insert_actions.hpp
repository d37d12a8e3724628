// Which actions form what stands between the halves of a mold.
#pragma once

#include <cstddef>
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

}  // namespace moldlight
