// Search downhill: the best basins of the sphere are followed by scores, and the best directions by exact
// figures.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sweep/contender.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/direction_rating.hpp"
#include "sweep/scoring.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

/// Of the part's area: what is worse than the best by more is not polished.
inline constexpr double k_polished_share = 0.003;

/// What both work with.
struct Descent {
  const PartModel& model;
  const DirectionRating& rating;
  /// Spares exact figures to directions that are surely worse; scores by undercut alone.
  ScoringPool& rays;
  DirectionMeasurer& measurer;
  const SweepClock& clock;
  /// Called with every direction tried, in an order that does not depend on the number of threads.
  std::function<void(const EvaluatedDirection&)> evaluated;
};

/// Starts at the best contenders in `order` (at most `most`, well apart from each other) and tries six
/// directions around the best of each, in steps that are halved from 2 degrees down to a half. Gives what
/// is better than, or away from, every contender there was; basins that meet go on as one.
[[nodiscard]] std::vector<Contender> refine_basins(const Descent& descent,
                                                   std::span<const Contender> contenders,
                                                   std::span<const std::size_t> order, std::size_t most);

/// Looks around a measured contender on rings of 2.4 to 0.08 degrees, goes on from whatever is better until
/// nothing is, and then in steps down to a 20,000th of a degree, as an axis found from facets is off by their
/// rounding. Gives the best found where it is better than the contender. Ends early, with what is found, once
/// the clock says to stop.
[[nodiscard]] std::optional<Contender> polish(const Descent& descent, const Contender& start);

}  // namespace moldlight
