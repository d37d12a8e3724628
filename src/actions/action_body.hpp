// The solid that an action moves to release what it forms, and how it moves.
#pragma once

#include <functional>
#include <optional>

#include <glm/mat4x4.hpp>

#include "actions/side_action.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// The closed, oriented solid that an action moves, beside the part, in its unit and place. It touches the
/// undercut pieces that the action releases and the faces that it forms with them, but for what of them it
/// does not free. A slide's goes as far out as the part reaches; what cannot leave sideways is a slice, with
/// this share (0, 1] of the usual thickness. Through holes are stopped at their far end. Nothing for what is
/// stripped off, which has no body of its own.
using BodyShaper = std::function<std::optional<TriangleMesh>(double thickness)>;
/// Model and split mesh must outlive it, the plan need not; it has its undercuts.
[[nodiscard]] BodyShaper body_shaper(const PartModel& model, const SplitMesh& split, const ExactQuery& query,
                                     const ActionPlan& plan, std::size_t action);

/// Where a body is at a share [0, 1] of its travel: points of the part's own unit and place.
[[nodiscard]] glm::dmat4 action_motion(const SideAction& action, double share);

/// By how much it has turned about its axis by then, radians; 0 for what does not turn.
[[nodiscard]] double turn_of(const SideAction& action, double share);

}  // namespace moldlight
