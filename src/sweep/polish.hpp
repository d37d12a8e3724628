// Polishing: the best directions are followed downhill by exact figures.
#pragma once

#include <functional>
#include <optional>

#include "sweep/contender.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/direction_rating.hpp"
#include "sweep/scoring.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

/// Of the part's area: what is worse than the best by more is not polished.
inline constexpr double k_polished_share = 0.003;

struct Polishing {
  const PartModel& model;
  const DirectionRating& rating;
  /// Spares exact figures to directions that are surely worse; scores by undercut alone.
  ScoringPool& rays;
  DirectionMeasurer& measurer;
  const SweepClock& clock;
  /// Called with every direction tried, in an order that does not depend on the number of threads.
  std::function<void(const EvaluatedDirection&)> evaluated;
};

/// Looks around a measured contender on rings of 2.4 to 0.08 degrees, goes on from whatever is better until
/// nothing is, and then in steps down to a 20,000th of a degree, as an axis found from facets is off by their
/// rounding. Gives the best found where it is better than the contender. Ends early, with what is found, once
/// the clock says to stop.
[[nodiscard]] std::optional<Contender> polish(const Polishing& polishing, const Contender& start);

}  // namespace moldlight
