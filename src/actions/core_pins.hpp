// The core pins of an action.
#pragma once

#include <span>

#include "actions/side_action.hpp"
#include "actions/undercut_part.hpp"

namespace moldlight {

/// Notes in each slide and insert the most slender pin of those that form holes in it: through one of them,
/// and on through those that are in line with it.
void set_core_pins(const PartModel& model, const SplitMesh& split, const Release& release,
                   const Undercuts& undercuts, std::span<const UndercutPart> undercut_parts,
                   ActionPlan& plan);

}  // namespace moldlight
