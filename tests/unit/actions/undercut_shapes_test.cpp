// Undercuts of textbook shapes, and which of them share a slide by the angle between them.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"
#include "support/boxes.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

constexpr double k_clearance_mm = 3.0;

/// Open at both ends: a slide straight out may turn until it runs along the groove, and as much farther as
/// the flanks are parallel to it within the required draft.
TEST(VGroove, IsASlideThatMayTurnAsWideAsTheGroove) {
  constexpr double k_depth = 6.0, k_half = 5.0;
  SolidBuilder solid;
  solid.extrude(
      {{0, 0}, {30, 0}, {30, 10 - k_half}, {30 - k_depth, 10}, {30, 10 + k_half}, {30, 20}, {0, 20}}, {},
      40.0);
  const Planned planned = plan_of(solid.mesh());
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  const SideAction& action = planned.plan.actions.front();
  EXPECT_GT(action.direction.x, 1.0 - 1e-6);
  const double outward = k_half / std::hypot(k_half, k_depth);  // of a flank's normal, along x
  const double reach_deg = 90.0 + glm::degrees(std::asin(std::sin(glm::radians(k_tau_deg)) / outward));
  EXPECT_NEAR(action.interval.to_deg, reach_deg, 0.05);
  EXPECT_NEAR(action.interval.from_deg, -reach_deg, 0.05);
  EXPECT_NEAR(action.travel, k_depth + k_clearance_mm, 1e-3 * planned.model->frame.diagonal);
}

TEST(Dovetail, IsASlideAlongIt) {
  constexpr double k_length = 30.0;
  SolidBuilder solid;
  solid.extrude({{0, 0}, {40, 0}, {40, 20}, {24, 20}, {28, 12}, {12, 12}, {16, 20}, {0, 20}}, {}, k_length);
  const Planned planned = plan_of(solid.mesh());
  ASSERT_EQ(planned.plan.actions.size(), 1U) << actions_text(planned.plan);
  const SideAction& action = planned.plan.actions.front();
  ASSERT_EQ(action.kind, ActionKind::slide) << "both flanks at once, rather than two lifters";
  EXPECT_NEAR(std::abs(action.direction.y), 1.0, 1e-6);
  EXPECT_NEAR(action.travel, k_length + k_clearance_mm, 0.1);
  EXPECT_TRUE(planned.plan.unreleased.empty());
}

/// Six plates around the z axis that lean inward, each with a hole across it: from above one sees through its
/// middle, so that its sides are an undercut each.
TriangleMesh leaning_plates() {
  TriangleMesh all;
  for (int k = 0; k < 6; ++k) {
    Loop2 hole = regular_polygon(32, 3.0);
    for (glm::dvec2& point : hole) point += glm::dvec2(0, 6);
    SolidBuilder plate;
    plate.extrude({{-6, 0}, {6, 0}, {6, 12}, {-6, 12}}, {hole}, 2.0);
    TriangleMesh mesh = plate.mesh();
    for (glm::dvec3& vertex : mesh.vertices) vertex.y += 26.0 - 0.45 * vertex.z;
    all = test::joined(all, test::rotated(mesh, glm::angleAxis(glm::radians(60.0 * k), glm::dvec3(0, 0, 1))));
  }
  return all;
}

TEST(HolesAllAround, HaveASlideEachAlongTheirAxis) {
  const Planned planned = plan_of(leaning_plates());
  ASSERT_EQ(planned.plan.undercuts.size(), 12U);
  EXPECT_TRUE(planned.plan.unreleased.empty());
  ASSERT_EQ(actions_text(planned.plan), "6 slides");
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_EQ(action.feature, "hole");
    ASSERT_EQ(action.undercuts.size(), 2U);
    const glm::dvec3 &one = planned.plan.undercuts[action.undercuts[0]].undercut.centre,
                     &other = planned.plan.undercuts[action.undercuts[1]].undercut.centre;
    const glm::dvec3 outward(glm::normalize(glm::dvec2(one + other)), 0.0);
    EXPECT_GT(glm::dot(action.direction, outward), 0.9999);
  }
}

/// A pocket in a side, wider at its bottom by `wider` all around.
TriangleMesh pocket(double wider) {
  const auto mouth = [](double x, double more) {
    return test::Loop{{x, 5.0 - more, 8.0 - more},
                      {x, 15.0 + more, 8.0 - more},
                      {x, 15.0 + more, 12.0 + more},
                      {x, 5.0 - more, 12.0 + more}};
  };
  const glm::dvec3 low(0.0), high(20.0);
  SolidBuilder solid;
  solid.box(low, high, {1});
  solid.face(test::box_face(low, high, 1), {mouth(20.0, 0.0)});
  solid.walls(mouth(20.0, 0.0), mouth(12.0, 0.0));
  test::Loop step = mouth(12.0, wider);
  std::ranges::reverse(step);
  solid.face(step, {mouth(12.0, 0.0)});
  solid.walls(mouth(12.0, wider), mouth(10.0, wider));
  solid.face(mouth(10.0, wider));
  return solid.mesh();
}

TEST(PocketWiderAtItsBottom, IsASlideWhereThatIsLessThanTheLeastTravel) {
  const Planned planned = plan_of(pocket(0.02));
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  const SideAction& action = planned.plan.actions.front();
  EXPECT_NEAR(action.direction.x, 1.0, 1e-12);
  EXPECT_NEAR(action.travel, 10.0 + k_clearance_mm, 1e-3 * planned.model->frame.diagonal);
  EXPECT_TRUE(planned.plan.unreleased.empty());
  EXPECT_TRUE(std::ranges::any_of(planned.plan.specks, [](const Speck& speck) {
    return speck.of_undercut && speck.reason == SpeckReason::shallow && speck.area > 0.5;
  }));
}

TEST(PocketWiderAtItsBottom, IsNotReleasedByASlideWhereItIsMore) {
  const Planned planned = plan_of(pocket(0.2));
  EXPECT_TRUE(actions_text(planned.plan) != "1 slide" || !planned.plan.unreleased.empty());
}

/// A hook that hangs from a plate: its ledge is reached from the plate's side.
TEST(HookUnderALid, IsASlideByTheLengthOfItsLedge) {
  constexpr double k_ledge = 3.0;
  SolidBuilder solid;
  solid.extrude({{0, 10},
                 {10, 10},
                 {10, 2},
                 {12 + k_ledge, 2},
                 {12 + k_ledge, 4},
                 {12, 4},
                 {12, 10},
                 {40, 10},
                 {40, 12},
                 {0, 12}},
                {}, 30.0);
  const Planned planned = plan_of(solid.mesh());
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  const SideAction& action = planned.plan.actions.front();
  EXPECT_GT(action.direction.x, 1.0 - 1e-6);
  EXPECT_NEAR(action.travel, k_ledge + k_clearance_mm, 1e-3 * planned.model->frame.diagonal);
  EXPECT_FALSE(action.core_side) << "it hangs down";
}

/// Two pockets in one side, each drafted by 25 degrees to both sides of its own axis, which leans from the
/// other's.
TriangleMesh block_with_leaning_pockets(double between_deg) {
  constexpr double k_draft_deg = 25.0, k_deep = 6.0, k_half = 2.0;
  const glm::dvec3 low(0, 0, 0), high(40, 60, 20);
  SolidBuilder solid;
  solid.box(low, high, {1});
  std::vector<test::Loop> mouths;
  for (const double sense : {-1.0, 1.0}) {
    const double lean_deg = 0.5 * sense * between_deg, centre = 30.0 - 14.0 * sense;
    const auto side = [&](double by_deg, double half, double x) {
      return centre + half + (x - (high.x - k_deep)) * std::tan(glm::radians(lean_deg + by_deg));
    };
    const auto loop = [&](double x) {
      const double near = side(-k_draft_deg, -k_half, x), far = side(k_draft_deg, k_half, x);
      return test::Loop{{x, near, 5}, {x, far, 5}, {x, far, 15}, {x, near, 15}};
    };
    test::Loop floor = loop(high.x - k_deep), mouth = loop(high.x);
    mouths.push_back(mouth);
    solid.face(floor);
    std::ranges::reverse(floor);
    std::ranges::reverse(mouth);
    solid.walls(floor, mouth);
  }
  solid.face(box_face(low, high, 1), mouths);
  return solid.mesh();
}

/// Straight out of the side, as long as their draft allows for it.
TEST(LeaningPockets, ShareASlideThatReleasesBoth) {
  for (const double between_deg : {20.0, 40.0}) {
    const Planned planned = plan_of(block_with_leaning_pockets(between_deg));
    ASSERT_EQ(actions_text(planned.plan), "1 slide") << between_deg;
    EXPECT_NEAR(planned.plan.actions[0].direction.x, 1.0, 1e-9) << between_deg;
  }
  EXPECT_EQ(actions_text(plan_of(block_with_leaning_pockets(60.0)).plan), "2 slides");
}

/// Each of its pieces in three.
TEST(UndercutSamples, AreTheSameHoweverItIsCut) {
  for (const TriangleMesh& mesh : {laid(block_with_hole({.draft_deg = 2.0}), 20.0), box_with_hook(3.0)}) {
    const Planned planned = plan_of(mesh);
    const Undercut& undercut = planned.plan.undercuts[0].undercut;
    SplitMesh cut = *planned.result.split;
    Undercut finer = undercut;
    finer.pieces.clear();
    for (const std::uint32_t piece : undercut.pieces) {
      const auto [a, b, c] = cut.pieces[piece].corners;
      const auto middle = static_cast<VertexIndex>(cut.vertices.size());
      cut.vertices.push_back(cut.middle(piece));
      finer.pieces.push_back(piece);
      for (const auto& corners : {std::array{b, c, middle}, std::array{c, a, middle}}) {
        finer.pieces.push_back(static_cast<std::uint32_t>(cut.pieces.size()));
        cut.pieces.push_back(cut.pieces[piece]);
        cut.pieces.back().corners = corners;
      }
      cut.pieces[piece].corners = {a, b, middle};
    }
    const auto own = sample_undercut(*planned.model, *planned.result.split, undercut, 200);
    const auto other = sample_undercut(*planned.model, cut, finer, 200);
    ASSERT_EQ(own.size(), 200U);
    ASSERT_EQ(other.size(), own.size());
    for (std::size_t k = 0; k < own.size(); ++k)
      EXPECT_LT(glm::distance(own[k].position, other[k].position), 1e-6F) << k;
  }
}

}  // namespace
}  // namespace moldlight
