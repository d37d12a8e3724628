// The solid that an action moves to release what it forms, and how it moves.
#pragma once

#include <optional>

#include <glm/mat4x4.hpp>

#include "actions/side_action.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A closed, oriented solid beside the part, in its unit and place, that touches all undercut pieces that the
/// action releases and the faces that it forms with them: as far out as the part reaches for a slide, and a
/// slice of so much room as it has for what cannot leave sideways. Through holes are stopped at their far
/// end. It does not reach into the part by more than the tolerances of the action's own rays. Nothing for
/// what is stripped off, which has no body of its own.
[[nodiscard]] std::optional<TriangleMesh> action_body(const PartModel& model, const Classification& result,
                                                      const ActionPlan& plan, std::size_t action);

/// Where a body is at a share [0, 1] of its travel: points of the part's own unit and place.
[[nodiscard]] glm::dmat4 action_motion(const SideAction& action, double share);

/// By how much it has turned about its axis by then, radians; 0 for what does not turn.
[[nodiscard]] double turn_of(const SideAction& action, double share);

}  // namespace moldlight
