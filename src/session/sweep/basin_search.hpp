// Refinement: the best basins of the sphere are followed downhill.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "session/sweep/contender.hpp"
#include "session/sweep/direction_judge.hpp"
#include "session/sweep/scoring.hpp"
#include "session/sweep/sweep_result.hpp"
#include "session/sweep/sweep_watch.hpp"

namespace moldlight {

struct BasinSearch {
  const DirectionJudge& judge;
  ScoringPool& rays;
  const SweepWatch& watch;
  /// Told of every direction tried, in an order that does not depend on the number of threads.
  std::function<void(const EvaluatedDirection&)> evaluated;
};

/// Starts at the best contenders in `order` (at most `most`, well apart from each other) and tries six
/// directions around the best of each, in steps that are halved from 2 degrees down to a half. Gives what
/// is better than, or away from, every contender there was; basins that meet go on as one.
[[nodiscard]] std::vector<Contender> refine_basins(const BasinSearch& search,
                                                   std::span<const Contender> contenders,
                                                   std::span<const std::size_t> order, std::size_t most);

}  // namespace moldlight
