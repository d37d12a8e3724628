// How far a pull may lean.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sweep/contender.hpp"
#include "sweep/direction_scorer.hpp"
#include "sweep/sweep_result.hpp"
#include "sweep/sweep_tools.hpp"

namespace moldlight {

/// Leans the direction towards 8 sides, by angles that grow fourfold up to k_widest_tilt_deg and are then
/// narrowed down to a tenth, until the scored undercut has grown by more than `growth` (model units squared)
/// over the direction's own score. The scorer must look at the same surface samples for every direction, so
/// that sampling noise mostly cancels (RayScorer). Empty if `stop` said so before the end.
[[nodiscard]] std::optional<TiltMargin> tilt_margin(DirectionScorer& scorer, const glm::dvec3& direction,
                                                    double growth, const std::function<bool()>& stop);

/// Of each direction, by the settings' growth and as far as there is time, each on one thread: one after the
/// other they would leave threads idle.
[[nodiscard]] std::vector<std::optional<TiltMargin>> tilt_margins(SweepTools& tools,
                                                                  std::span<const Contender> contenders);

}  // namespace moldlight
