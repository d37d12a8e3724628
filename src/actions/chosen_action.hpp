// A side action as it is told: its travel and what it may turn by as exact as they get.
#pragma once

#include <vector>

#include "actions/atom.hpp"

namespace moldlight {

struct ChosenContext {
  const PartModel& model;
  const SplitMesh& split;
  const Undercuts& undercuts;
  const PullFinder& pulls;
  const ActionSettings& settings;
  double unit_per_mm = 1.0;
};

[[nodiscard]] SideAction chosen_action(const ChosenContext& context, const std::vector<Atom>& atoms,
                                       const Column& column);

}  // namespace moldlight
