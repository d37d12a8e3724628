// Refinement: the best basins of the sphere are followed downhill.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sweep/contender.hpp"
#include "sweep/direction_rating.hpp"
#include "sweep/scoring.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

struct BasinSearch {
  const DirectionRating& rating;
  ScoringPool& rays;
  const SweepClock& clock;
  /// Called with every direction tried, in an order that does not depend on the number of threads.
  std::function<void(const EvaluatedDirection&)> evaluated;
};

/// Starts at the best contenders in `order` (at most `most`, well apart from each other) and tries six
/// directions around the best of each, in steps that are halved from 2 degrees down to a half. Gives what
/// is better than, or away from, every contender there was; basins that meet go on as one.
[[nodiscard]] std::vector<Contender> refine_basins(const BasinSearch& search,
                                                   std::span<const Contender> contenders,
                                                   std::span<const std::size_t> order, std::size_t most);

}  // namespace moldlight
