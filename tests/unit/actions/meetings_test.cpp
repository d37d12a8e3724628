// Slides whose ways cross would meet.
#include "actions/meetings.hpp"

#include <gtest/gtest.h>

#include "actions/actions_report.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// An angle of two walls with a blind pocket in each inner side: one is pulled along +x, the other along +y,
/// across the space that the walls enclose. `a` and `b` are the heights of the pockets' floors.
TriangleMesh angle_with_pockets(double a, double b) {
  SolidBuilder solid;
  // Along z; the inner sides at x = 10 and y = 10.
  const Loop2 profile = {{0, 0}, {60, 0}, {60, 10}, {10, 10}, {10, 60}, {0, 60}};
  const double top = 40.0;
  solid.face(at_height(Loop2(profile.rbegin(), profile.rend()), 0.0));
  solid.face(at_height(profile, top));
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{4}, std::size_t{5}}) {
    const glm::dvec2 from = profile[k], to = profile[(k + 1) % profile.size()];
    solid.face({{from.x, from.y, 0}, {to.x, to.y, 0}, {to.x, to.y, top}, {from.x, from.y, top}});
  }
  const glm::dvec3 a_low(5, 25, a), a_high(10, 35, a + 8), b_low(25, 5, b), b_high(35, 10, b + 8);
  solid.box(a_low, a_high, {1}, true);
  solid.box(b_low, b_high, {3}, true);
  const glm::dvec3 low(0, 10, 0), high(10, 60, top), low_b(10, 0, 0), high_b(60, 10, top);
  solid.face(box_face(low, high, 1), {box_face(a_low, a_high, 1)});
  solid.face(box_face(low_b, high_b, 3), {box_face(b_low, b_high, 3)});
  return solid.mesh();
}

TEST(Meetings, AreOfSlidesWhoseWaysCross) {
  const Planned planned = plan_of(angle_with_pockets(10, 10));
  ASSERT_EQ(actions_text(planned.plan), "2 slides");
  ASSERT_EQ(planned.plan.actions[0].meets, std::vector<std::size_t>{1});
  ASSERT_EQ(planned.plan.actions[1].meets, std::vector<std::size_t>{0});
  const ActionSettings settings;
  const ActionsReport report{*planned.model, planned.result, settings, planned.plan};
  EXPECT_EQ(actions_json(report)["actions"][0]["meets"], nlohmann::ordered_json::array({2}));
  EXPECT_NE(actions_table(report).find("their ways cross: rows 1 and 2."), std::string::npos);
}

TEST(Meetings, AreNoneAtDifferentHeights) {
  const Planned planned = plan_of(angle_with_pockets(5, 25));
  ASSERT_EQ(actions_text(planned.plan), "2 slides");
  for (const SideAction& action : planned.plan.actions) EXPECT_TRUE(action.meets.empty());
}

TEST(Meetings, AreNoneOfSlidesThatLeaveTheirOwnWays) {
  const Planned planned = plan_of(block_with_pockets(60.0));
  ASSERT_EQ(actions_text(planned.plan), "2 slides") << "side by side";
  for (const SideAction& action : planned.plan.actions) EXPECT_TRUE(action.meets.empty());
}

}  // namespace
}  // namespace moldlight
