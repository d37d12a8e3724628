// The cheapest set of the side actions that were found, without actions that meet where that can be helped.
#pragma once

#include <functional>
#include <vector>

#include "actions/chosen_action.hpp"

namespace moldlight {

struct LeastSetQuestions {
  /// More options that release an undercut part, for one whose slide or lifter meets another, or hits.
  std::function<std::vector<ActionOption>(std::size_t undercut_part)> alternatives;
  /// Finds the bodies of a plan, roughly or finely.
  std::function<void(ActionPlan&, bool fine)> measure;
};

/// A plan that has everything but what was dropped. Which of them meet is found of those that are chosen: two
/// that do are not chosen together again unless no set of the options, the alternatives of the undercut parts
/// of both among them, does without such a pair. None is chosen whose body hits the part, or that of an
/// action that releases more. Throws Cancelled.
[[nodiscard]] ActionPlan least_set(const ChosenContext& context,
                                   const std::vector<UndercutPart>& undercut_parts,
                                   std::vector<ActionOption> options, const LeastSetQuestions& ask,
                                   const Progress& progress);

}  // namespace moldlight
