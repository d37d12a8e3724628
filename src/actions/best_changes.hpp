// Which changes of the part save most side actions.
#pragma once

#include <cstddef>
#include <vector>

#include "actions/side_action.hpp"

namespace moldlight {

/// Undercuts that are freed together, and the actions that this saves: numbers in the plan, rising.
struct SavingChange {
  std::vector<std::size_t> undercuts, actions;
  double saves = 0.0;  // prices of the actions
};

/// At most three, which save most first; of equal ones that which frees fewer undercuts.
[[nodiscard]] std::vector<SavingChange> best_changes(const ActionPlan& plan, const ActionPrices& prices);

}  // namespace moldlight
