// Lower bound of the side actions that a part's undercuts need, without a search for side actions.
#pragma once

#include "actions/action_settings.hpp"
#include "actions/undercut.hpp"

namespace moldlight {

struct LeastActions {
  double weight = 0.0;
  double beyond = 0.0;  // area of undercuts that the k_most_actions largest do not form
};

/// What the side actions of a direction come to at least. Undercuts are put together that one slide might
/// form, with what may lie between them: each such group needs an action of its own. That is a slide, the
/// lightest, but for what goes all the way round, from which the part may be stripped.
[[nodiscard]] LeastActions least_actions(const PartModel& model, const SplitMesh& split,
                                         const Undercuts& undercuts, const glm::dvec3& direction,
                                         const ActionSettings& settings);

}  // namespace moldlight
