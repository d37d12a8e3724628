// Scoring one parting direction quickly, for ranking many. Final figures never come from here.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/region.hpp"

namespace moldlight {

/// Model units squared.
struct DirectionScore {
  RegionValues areas;
  double undercut_error = 0.0;  // 95 % level: sampling, and what the method leaves in doubt
  double shadow_area = 0.0;     // of the part along the direction; 0 if one beside another was given up
  bool given_up = false;        // the areas are rough: the scorer stopped early
  /// Which of the samples are undercut, from a scorer that has the same samples for every direction.
  std::shared_ptr<const std::vector<bool>> undercut_samples;

  [[nodiscard]] double undercut() const { return areas[Region::undercut]; }
  /// Undercut areas that it is surely (at the 95 % level) not below and not above.
  [[nodiscard]] double optimistic() const { return undercut() - undercut_error; }
  [[nodiscard]] double pessimistic() const { return undercut() + undercut_error; }
};

/// Undercut area above which nothing is given up.
inline constexpr double k_no_limit = std::numeric_limits<double>::infinity();

/// A direction to score, and the undercut area above which it may be given up early.
struct ScoringTask {
  glm::dvec3 direction{0, 0, 1};
  double give_up_above = k_no_limit;
  /// A direction nearby, scored by the same samples: the two differ in few of them, so that it is soon
  /// certain which one has more undercut.
  const DirectionScore* beside = nullptr;
  /// With `beside`: nothing matters but on which side of the limit the area is.
  bool side_only = false;
};

/// One thread's scorer. The same task gets the same score to the bit, whatever was scored before or with it
/// and on whichever thread.
class DirectionScorer {
 public:
  virtual ~DirectionScorer() = default;
  DirectionScorer(const DirectionScorer&) = delete;
  DirectionScorer& operator=(const DirectionScorer&) = delete;

  /// How many directions are best scored together; at least 1.
  [[nodiscard]] virtual std::size_t batch_size() const { return 1; }
  /// Scores of at most so many tasks, in their order; directions are unit vectors.
  [[nodiscard]] virtual std::vector<DirectionScore> score(std::span<const ScoringTask> tasks) = 0;

 protected:
  DirectionScorer() = default;
};

}  // namespace moldlight
