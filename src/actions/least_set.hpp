// The cheapest set of the side actions that were found, without actions that meet where that can be helped.
#pragma once

#include <functional>
#include <vector>

#include "actions/chosen_action.hpp"

namespace moldlight {

/// Why an action of a plan cannot be built.
struct ActionFault {
  std::size_t action = 0;
  RejectReason reason = RejectReason::hits_part;
  BodyHit hit = {};  // of its body; of what has none the place alone
};

/// What the search asks while it chooses.
struct LeastSetQuestions {
  /// More columns that release an atom, for one whose slide or lifter meets another.
  std::function<std::vector<Column>(std::size_t atom)> ways_round;
  /// What of a plan cannot be built; fills in its patches and bodies.
  std::function<std::vector<ActionFault>(ActionPlan& plan)> faults;
  /// Columns for atoms, which it may divide, that nothing else releases any more.
  std::function<std::vector<Column>(const std::vector<std::size_t>& atoms)> last_resort;
};

/// Which actions meet is found of those that are chosen: two that do are not chosen together again unless no
/// set of the columns, the ways round of the atoms of both among them, does without such a pair. A column
/// whose action cannot be built is given up and rejected, and others are chosen in its place; of two that
/// hit each other, and that nothing else spares, the smaller one. Throws Cancelled.
[[nodiscard]] ActionPlan least_set(const ChosenContext& context, const std::vector<Atom>& atoms,
                                   std::vector<Column> columns, const LeastSetQuestions& ask,
                                   const Progress& progress);

}  // namespace moldlight
