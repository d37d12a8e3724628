// Spares a thorough scorer the directions that a quick one sees to be hopeless.
#pragma once

#include <memory>

#include "mold/sweep/direction_scorer.hpp"

namespace moldlight {

/// Asks `quick` first; only what it does not give up goes to `thorough`.
class ScreenedScorer : public DirectionScorer {
 public:
  ScreenedScorer(std::unique_ptr<DirectionScorer> quick, std::unique_ptr<DirectionScorer> thorough);

  [[nodiscard]] DirectionScore score(const glm::dvec3& direction) override;

 private:
  std::unique_ptr<DirectionScorer> quick_, thorough_;
};

}  // namespace moldlight
