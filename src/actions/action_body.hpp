// The solid that an action moves to release what it forms, and how it moves.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "actions/side_action.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Shapes the closed, oriented solid that an action moves, beside the part, in its unit and place. It touches
/// the undercut pieces that the action releases and the faces that it forms with them, but for what of them
/// it does not free. A slide's goes as far out as the part reaches; what cannot leave sideways is a slice.
/// Through holes are stopped at their far end.
class BodyShaper {
 public:
  /// Model and split mesh must outlive it, the plan need not; it has its undercuts.
  BodyShaper(const PartModel& model, const SplitMesh& split, const ExactQuery& query, const ActionPlan& plan,
             std::size_t action);
  ~BodyShaper();

  /// With this share (0, 1] of the usual thickness, where it is a slice, without stems. Nothing for what is
  /// stripped off, which has no body of its own.
  [[nodiscard]] std::optional<TriangleMesh> shape(double thickness);
  /// Whether the last shape would be another one with another share: not what reaches out of the mold, or
  /// round a thread.
  [[nodiscard]] bool thins() const;
  /// The stems of a lifter, each from its head down to below the part.
  [[nodiscard]] std::vector<TriangleMesh> stems() const;
  /// Leaves out the surface from which these points of the body come, at which it is in the part. False, with
  /// nothing left out, where that and what was left out before are more than may stay blocked
  /// (k_blocked_share).
  bool leave_out(std::span<const glm::dvec3> points);

 private:
  class Maker;
  std::unique_ptr<Maker> maker_;
};

/// Where a body is at a share [0, 1] of its travel: points of the part's own unit and place.
[[nodiscard]] glm::dmat4 action_motion(const SideAction& action, double share);

/// By how much it has turned about its axis by then, radians; 0 for what does not turn.
[[nodiscard]] double turn_of(const SideAction& action, double share);

}  // namespace moldlight
