// What was tried for undercuts that nothing releases well, and why it was not taken.
#pragma once

#include <span>

#include "actions/side_action.hpp"
#include "actions/undercut_part.hpp"

namespace moldlight {

/// Leaves in the plan, by undercut: slides that would lean too much, the shortest lifter without its room,
/// pins that would be too thin, `rings` that would be stretched too far, and of what the plan has there,
/// which hits, the first of each other kind, and lifters that are shorter than the one without room.
void keep_rejected(const PartModel& model, std::span<const UndercutPart> undercut_parts,
                   std::span<const RejectedAction> rings, const glm::dvec3& direction, ActionPlan& plan);

}  // namespace moldlight
