// How far a pull may lean.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sweep/direction_scorer.hpp"
#include "sweep/scoring_pools.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Leans the direction towards 8 sides, by angles that grow fourfold up to k_widest_tilt_deg and are then
/// narrowed down to a tenth, until the scored undercut has grown by more than `growth` (model units squared)
/// over the direction's own score. The scorer must look at the same surface samples for every direction, so
/// that sampling noise mostly cancels (RayScorer). Empty if `stop` said so before the end.
[[nodiscard]] std::optional<TiltMargin> tilt_margin(DirectionScorer& scorer, const glm::dvec3& direction,
                                                    double growth, const std::function<bool()>& stop);

/// What many are found with.
struct TiltSearch {
  const ScoringPools& pools;
  SweepClock& clock;
  double growth;  // as above
  int jobs;
};
/// Of each direction, as far as there is time, each on one thread: one after the other they would leave
/// threads idle.
[[nodiscard]] std::vector<std::optional<TiltMargin>> tilt_margins(const TiltSearch& search,
                                                                  std::span<const glm::dvec3> directions);

}  // namespace moldlight
