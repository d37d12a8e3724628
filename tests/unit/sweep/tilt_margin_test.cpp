// The tilt margin of undercuts that are known.
#include "sweep/tilt_margin.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "sweep/candidates/candidate.hpp"

namespace moldlight {
namespace {

constexpr double k_growth_deg = 2.0;
const double k_farthest_deg = k_growth_deg / std::cos(glm::radians(22.5));  // between two of the eight sides

/// An undercut that grows by 1 a degree of lean from z towards one side, and not at all away from it.
class LeaningScorer : public DirectionScorer {
 public:
  explicit LeaningScorer(const glm::dvec3& side) : side_(side) {}
  [[nodiscard]] std::vector<DirectionScore> score(std::span<const ScoringTask> tasks) override {
    std::vector<DirectionScore> scores;
    for (const ScoringTask& task : tasks) {
      scores.emplace_back().areas[Region::undercut] =
          std::max(0.0, glm::degrees(std::asin(glm::dot(task.direction, side_))));
    }
    return scores;
  }

 private:
  glm::dvec3 side_;
};

glm::dvec3 side_at(double deg) { return {std::cos(glm::radians(deg)), std::sin(glm::radians(deg)), 0.0}; }

std::optional<TiltMargin> margin_towards(const glm::dvec3& side, double growth) {
  LeaningScorer scorer(side);
  return tilt_margin(scorer, {0, 0, 1}, growth, [] { return false; });
}

TEST(TiltMargin, IsFoundTowardsWhicheverSide) {
  for (double side_deg = 0.0; side_deg < 360.0; side_deg += 15.0) {
    const auto margin = margin_towards(side_at(side_deg), k_growth_deg);
    ASSERT_TRUE(margin);
    const std::array past{ScoringTask{.direction = margin->toward}};
    EXPECT_LE(margin->deg, k_farthest_deg) << side_deg;
    EXPECT_GE(margin->deg, 0.89 * k_growth_deg) << side_deg;
    EXPECT_GT(line_angle_deg(margin->toward, {0, 0, 1}), 1.001 * margin->deg) << "a lean that is past it";
    EXPECT_GT(LeaningScorer(side_at(side_deg)).score(past).front().undercut(), k_growth_deg) << side_deg;
  }
}

TEST(TiltMargin, IsTheWidestLookedAtWhereNothingGrows) {
  const auto margin = margin_towards(side_at(0.0), 90.0);
  ASSERT_TRUE(margin);
  EXPECT_TRUE(margin->at_least());
}

TEST(TiltMargin, IsUnknownWhereItIsStopped) {
  LeaningScorer scorer(side_at(0.0));
  EXPECT_FALSE(tilt_margin(scorer, {0, 0, 1}, k_growth_deg, [] { return true; }));
}

}  // namespace
}  // namespace moldlight
