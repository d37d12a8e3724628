#include "mold/sweep/screened_scorer.hpp"

#include <cmath>
#include <utility>

namespace moldlight {

ScreenedScorer::ScreenedScorer(std::unique_ptr<DirectionScorer> quick,
                               std::unique_ptr<DirectionScorer> thorough)
    : quick_(std::move(quick)), thorough_(std::move(thorough)) {}

DirectionScore ScreenedScorer::score(const glm::dvec3& direction) {
  if (std::isfinite(limit())) {
    quick_->give_up_above(limit());
    const DirectionScore glance = quick_->score(direction);
    if (glance.given_up) return glance;
  }
  thorough_->give_up_above(limit());
  return thorough_->score(direction);
}

}  // namespace moldlight
