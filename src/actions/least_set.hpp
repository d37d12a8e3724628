// The cheapest set of the side actions that were found, without actions that meet where that can be helped.
#pragma once

#include <functional>
#include <vector>

#include "actions/chosen_action.hpp"

namespace moldlight {

/// More options that release an undercut part, for one whose slide or lifter meets another.
using Alternatives = std::function<std::vector<ActionOption>(std::size_t undercut_part)>;

/// A plan that has everything but its patches and what was dropped. Which of them meet is found of those that
/// are chosen: two that do are not chosen together again unless no set of the options, `alternatives` of the
/// undercut parts of both among them, does without such a pair. Throws Cancelled.
[[nodiscard]] ActionPlan least_set(const ChosenContext& context,
                                   const std::vector<UndercutPart>& undercut_parts,
                                   std::vector<ActionOption> options, const Alternatives& alternatives,
                                   const Progress& progress);

}  // namespace moldlight
