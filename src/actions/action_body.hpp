// The solid that an action moves to release what it forms, and how it moves.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <glm/mat4x4.hpp>

#include "actions/side_action.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// The closed, oriented solid that an action moves, beside the part, in its unit and place. It touches the
/// undercut pieces that the action releases and the faces that it forms with them, but for what of them it
/// does not free. A slide's goes as far out as the part reaches, a lifter's stem as far out of its half.
/// Through holes are stopped at their far end.
class ActionBody {
 public:
  struct Context {
    const PartModel& model;
    const SplitMesh& split;
    const ExactQuery& query;
    double stem = 0.0;  // side of the square that carries a lifter, the part's unit
  };
  /// Of an action of a plan that has its patches.
  ActionBody(const Context& context, const ActionPlan& plan, std::size_t action);

  /// What cannot leave sideways is a slice, with this share (0, 1] of the usual thickness. A slide keeps off
  /// walls that lean against its way by less than tau, and a thread's core off the thread, the more, the less
  /// the share is. Nothing for what is stripped off, which has no body.
  [[nodiscard]] std::optional<TriangleMesh> shaped(double thickness) const;
  /// From now on without the surface from which these points of the body come; false, and nothing changes,
  /// where that is more than may stay blocked.
  bool trim(std::span<const glm::dvec3> points);

 private:
  class Maker;
  std::shared_ptr<const Maker> maker_;  // not null
};

/// Where a body is at a share [0, 1] of its travel: points of the part's own unit and place.
[[nodiscard]] glm::dmat4 action_motion(const SideAction& action, double share);

/// By how much it has turned about its axis by then, radians; 0 for what does not turn.
[[nodiscard]] double turn_of(const SideAction& action, double share);

}  // namespace moldlight
