// The cheapest set of the side actions that were found, without actions that meet where that can be helped.
#pragma once

#include <functional>
#include <vector>

#include "actions/chosen_action.hpp"

namespace moldlight {

/// More columns that release an atom, for one whose slide or lifter meets another.
using WaysRound = std::function<std::vector<Column>(std::size_t atom)>;

/// A plan that has everything but its patches and what was dropped. Which of them meet is found of those that
/// are chosen: two that do are not chosen together again unless no set of the columns, `ways_round` of the
/// atoms of both among them, does without such a pair. Throws Cancelled.
[[nodiscard]] ActionPlan least_set(const ChosenContext& context, const std::vector<Atom>& atoms,
                                   std::vector<Column> columns, const WaysRound& ways_round,
                                   const Progress& progress);

}  // namespace moldlight
