// Scoring many directions on several threads, with the same result whatever their number.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "sweep/direction_scorer.hpp"

namespace moldlight {

/// A pool of scorers, one a thread, kept from call to call.
class ScoringPool {
 public:
  /// Makes a scorer; called on the thread that will use it.
  using MakeScorer = std::function<std::unique_ptr<DirectionScorer>()>;
  /// Called with every score, in any order, one call at a time.
  using Listener = std::function<void(std::size_t index, const DirectionScore& score)>;

  /// Makes do with the threads that could be started; throws std::system_error where none could.
  ScoringPool(MakeScorer make_scorer, int jobs);
  ~ScoringPool();
  ScoringPool(const ScoringPool&) = delete;
  ScoringPool& operator=(const ScoringPool&) = delete;

  /// Scores of the tasks, in their order; a scorer gets as many at once as it likes to, but no more than its
  /// thread's share. `stop`, if there is one, is asked in between: once it says true the rest stays without a
  /// score. Rethrows what a scorer throws.
  [[nodiscard]] std::vector<std::optional<DirectionScore>> score(std::span<const ScoringTask> tasks,
                                                                 const std::function<bool()>& stop,
                                                                 const Listener& listener);

  [[nodiscard]] int jobs() const { return jobs_; }
  /// Threads of a pool for so many jobs; 0 takes all cores.
  [[nodiscard]] static int threads(int jobs);

 private:
  struct Workers;
  int jobs_;
  std::unique_ptr<Workers> workers_;
};

}  // namespace moldlight
