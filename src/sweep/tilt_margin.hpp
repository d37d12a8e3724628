// How far a pull may lean.
#pragma once

#include <functional>
#include <optional>

#include <glm/vec3.hpp>

#include "sweep/direction_scorer.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Leans the direction towards 8 sides, by angles that grow fourfold up to k_widest_tilt_deg and are then
/// narrowed down to a tenth, until the scored undercut has grown by more than `growth` (model units squared)
/// over the direction's own score. The scorer must look at the same surface samples for every direction, so
/// that sampling noise mostly cancels (RayScorer). Empty if `stop` said so before the end.
[[nodiscard]] std::optional<TiltMargin> tilt_margin(DirectionScorer& scorer, const glm::dvec3& direction,
                                                    double growth, const std::function<bool()>& stop);

}  // namespace moldlight
