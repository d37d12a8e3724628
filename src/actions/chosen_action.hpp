// A side action as it is shown: its travel and what it may turn by as exact as they get.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "actions/undercut_part.hpp"

namespace moldlight {

struct ChosenContext {
  const PartModel& model;
  const SplitMesh& split;
  const Undercuts& undercuts;
  const PullFinder& pulls;
  const ActionSettings& settings;
  double unit_per_mm = 1.0, lateral = 0.0;  // the lateral tolerance in the part's unit
  PlanDetail detail = PlanDetail::whole;
  double most_left = std::numeric_limits<double>::infinity();  // area at which the search ends
};

/// The least travel of a lifter, from the way's own on, at which the samples are clear; the way's own where
/// that would be longer by more than a twentieth. Share of the diagonal.
[[nodiscard]] double clear_length(const Release& release, std::span<const UndercutSample> samples,
                                  LifterWay way);

[[nodiscard]] SideAction chosen_action(const ChosenContext& context,
                                       const std::vector<UndercutPart>& undercut_parts,
                                       const ActionOption& option);

}  // namespace moldlight
