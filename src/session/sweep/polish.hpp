// Polishing: the best of the search are followed downhill once more, by many more samples.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "session/sweep/contender.hpp"
#include "session/sweep/direction_judge.hpp"
#include "session/sweep/scoring_engine.hpp"
#include "session/sweep/sweep_result.hpp"
#include "session/sweep/sweep_watch.hpp"

namespace moldlight {

struct Polishing {
  const DirectionJudge& judge;
  ScoringEngine& engine;
  /// What the contenders were scored by; scores what replaces them.
  ScoringPool& closer;
  const SweepWatch& watch;
  const SweepSettings& settings;
  double total_area = 0.0;  // of the part, in its unit squared
  /// Told of every direction tried, in an order that does not depend on the number of threads.
  std::function<void(const EvaluatedDirection&)> evaluated;
};

/// Looks around the best of what was found by search and follows it downhill, on the same surface samples for
/// all directions, so that a step's gain is not lost in the noise of the scores. The surface of undercut
/// areas is creased: a descent alone ends in a crease. What then seems best is told from the rest by many
/// more samples, and replaces its contender where it is better. `order`: the contenders, best first. Once the
/// watch has stopped, the rest of the contenders stay as they are.
void polish(const Polishing& polishing, std::vector<Contender>& contenders,
            std::span<const std::size_t> order);

}  // namespace moldlight
