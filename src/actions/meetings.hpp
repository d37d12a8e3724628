// Slides that would meet each other on their ways.
#pragma once

#include "actions/side_action.hpp"

namespace moldlight {

/// Fills in `meets` of each slide, inclined ones among them: the others whose way it crosses. The way of a
/// slide is what its surface sweeps out to beyond the part, and its travel on. Two slides whose ways cross
/// stand in each other's way whichever goes first, as long as each reaches outward along its own direction.
void find_meetings(const PartModel& model, const SplitMesh& split, const Release& release, ActionPlan& plan);

}  // namespace moldlight
