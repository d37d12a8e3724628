// Directions that lean a little from an axis of the part.
#include "sweep/axis_beside.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/solid_builder.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

using test::Loop;
using test::SolidBuilder;

/// A block with a straight pocket in its top, 8 by 8 and 10 deep.
TriangleMesh tilted_block() {
  SolidBuilder solid;
  solid.box({0, 0, 0}, {20, 20, 14}, std::vector<int>{5});
  const Loop rim = {{6, 6, 14}, {14, 6, 14}, {14, 14, 14}, {6, 14, 14}};
  Loop floor = rim;
  for (glm::dvec3& corner : floor) corner.z -= 10.0;
  solid.walls({floor.rbegin(), floor.rend()}, {rim.rbegin(), rim.rend()});
  solid.face(floor);
  solid.face(test::box_face({0, 0, 0}, {20, 20, 14}, 5), {rim});
  return solid.mesh();
}

glm::dvec3 leaning(double degrees) {
  return {std::sin(glm::radians(degrees)), 0.0, std::cos(glm::radians(degrees))};
}

TEST(AxisBeside, IsListedWithItsFigures) {
  const auto model = test::model_of(tilted_block());
  SweepSettings settings;
  settings.rank = SweepRank::objective;
  settings.directions = 100;
  settings.user_directions = {leaning(0.6)};
  const SweepResult result = run_sweep(model, settings, Progress{}, {});
  const auto given = std::ranges::find_if(
      result.candidates, [](const SweepCandidate& each) { return each.candidate.from_user(); });
  ASSERT_NE(given, result.candidates.end());
  ASSERT_TRUE(given->axis);
  EXPECT_NEAR(given->axis->angle_deg, 0.6, 1e-9);
  EXPECT_EQ(given->axis->direction, glm::dvec3(0, 0, 1));
  EXPECT_EQ(given->axis->classification.reverse_draft.area, 0.0) << "along the pocket nothing leans";
  EXPECT_GT(given->classification.reverse_draft.area, 0.0);
  const Classification along = classify_exact(*model, {glm::dvec3(0, 0, 1), {}}, Progress{});
  EXPECT_EQ(given->axis->classification.areas[Region::undercut], along.areas[Region::undercut]);
  EXPECT_NE(axis_beside_text(*model, *given).find("0.6° from"), std::string::npos);
  for (const SweepCandidate& each : result.candidates) {
    if (std::abs(each.candidate.direction.z) > 1.0 - 1e-12) {
      EXPECT_FALSE(each.axis) << "the axis itself";
    }
  }
}

TEST(AxisBeside, IsWithinTheRequiredDraft) {
  const std::vector<Candidate> all = {{{0, 0, 1}, {{CandidateKind::axis, "z", 0.0}}},
                                      {leaning(0.5), {{CandidateKind::uniform, "", 0.0}}}};
  const std::vector<Candidate> axes = axes_of(all);
  ASSERT_EQ(axes.size(), 1U);
  EXPECT_TRUE(axis_beside(axes, leaning(0.9), 1.0));
  EXPECT_FALSE(axis_beside(axes, leaning(1.1), 1.0));
  EXPECT_FALSE(axis_beside(axes, leaning(0.01), 1.0)) << "the axis itself";
  const auto below = axis_beside(axes, -leaning(0.9), 1.0);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->direction, glm::dvec3(0, 0, -1)) << "on the direction's side";
}

}  // namespace
}  // namespace moldlight
