// Scoring one parting direction quickly, for ranking many. Final figures never come from here.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/region.hpp"

namespace moldlight {

/// Model units squared.
struct DirectionScore {
  RegionValues areas;
  double undercut_error = 0.0;  // 95 % level: sampling, and what the method leaves in doubt
  /// Lower bound of the undercut area that holds whatever the samples hit: the projected undercut from the
  /// shadow's area (method: sum |n.d| A - 2 S), less its error; 0 where the scorer has none.
  double undercut_bound = 0.0;
  double shadow_area = 0.0;  // of the part along the direction
  bool given_up = false;  // the areas are rough: the scorer stopped early, see DirectionScorer::give_up_above

  [[nodiscard]] double undercut() const { return areas[Region::undercut]; }
  /// Undercut areas that it is surely (at the 95 % level) not below and not above.
  [[nodiscard]] double optimistic() const { return std::max(undercut_bound, undercut() - undercut_error); }
  [[nodiscard]] double pessimistic() const { return undercut() + undercut_error; }
};

/// A direction to score, and the undercut area above which it may be given up early.
struct ScoringTask {
  glm::dvec3 direction{0, 0, 1};
  double give_up_above = std::numeric_limits<double>::infinity();
};

/// One thread's scorer. The same direction and limit give the same score to the bit, whatever was scored
/// before or with it and on whichever thread.
class DirectionScorer {
 public:
  virtual ~DirectionScorer() = default;
  DirectionScorer(const DirectionScorer&) = delete;
  DirectionScorer& operator=(const DirectionScorer&) = delete;

  /// Score for a unit direction.
  [[nodiscard]] virtual DirectionScore score(const glm::dvec3& direction) = 0;

  /// How many directions are best scored together; at least 1.
  [[nodiscard]] virtual std::size_t batch_size() const { return 1; }
  /// Scores of so many tasks, in their order.
  [[nodiscard]] virtual std::vector<DirectionScore> score_all(std::span<const ScoringTask> tasks) {
    std::vector<DirectionScore> scores;
    for (const ScoringTask& task : tasks) {
      give_up_above(task.give_up_above);
      scores.push_back(score(task.direction));
    }
    return scores;
  }

  /// From now on a direction whose undercut is certain to be above `undercut` may be given up early.
  void give_up_above(double undercut) { limit_ = undercut; }

 protected:
  DirectionScorer() = default;
  [[nodiscard]] double limit() const { return limit_; }

 private:
  double limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace moldlight
