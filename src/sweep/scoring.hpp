// Scoring many directions on several threads, with the same result whatever their number.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <tbb/task_arena.h>

#include "sweep/direction_scorer.hpp"

namespace moldlight {

/// Scorers, one a thread, kept from call to call.
class ScoringPool {
 public:
  /// Makes a scorer; called where one is first needed.
  using MakeScorer = std::function<std::unique_ptr<DirectionScorer>()>;
  /// Called with every score, in any order, one call at a time.
  using Listener = std::function<void(std::size_t index, const DirectionScore& score)>;

  ScoringPool(MakeScorer make_scorer, int jobs);

  /// Scores of the tasks, in their order; a scorer gets as many at once as it likes to, but no more than its
  /// thread's share. `stop`, if there is one, is asked in between: once it says true the rest stays without a
  /// score. Rethrows what a scorer throws.
  [[nodiscard]] std::vector<std::optional<DirectionScore>> score(std::span<const ScoringTask> tasks,
                                                                 const std::function<bool()>& stop,
                                                                 const Listener& listener);

  /// Threads of a pool for so many jobs; 0 takes all cores.
  [[nodiscard]] static int threads(int jobs);

 private:
  MakeScorer make_scorer_;
  std::vector<std::unique_ptr<DirectionScorer>> scorers_;
  tbb::task_arena arena_;
};

}  // namespace moldlight
