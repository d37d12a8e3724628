// What a side action forms, in a toolmaker's words.
#pragma once

#include <string>

#include "actions/release.hpp"
#include "actions/side_action.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

struct FeatureContext {
  const PartModel& model;
  const SplitMesh& split;
  const Release& release;
};

/// "8 vents", "hole", "2 hooks, 1 recess": of the action's undercuts. A hole is round, a slot longer than
/// wide, a window neither; three of one size and shape are vents. What does not go through the part is a hook
/// or a groove where it is open at both sides, a recess else.
[[nodiscard]] std::string feature_text(const FeatureContext& context, const ActionPlan& plan,
                                       const SideAction& action);

/// The core pin of an undercut that is a round hole, and the axis (unit) along which it is pulled; none of
/// others.
struct RoundHole {
  CorePin pin;
  glm::dvec3 axis{0, 0, 1};
};
[[nodiscard]] std::optional<RoundHole> round_hole(const PartModel& model, const SplitMesh& split,
                                                  const Undercut& patch);

}  // namespace moldlight
