// Slides whose ways cross would meet, and lifters.
#include "actions/meetings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

/// Pinned to slides, nothing else is left to choose: one of them cannot be built.
TEST(Meetings, OfSlidesWhoseBodiesHitEachOtherLeaveOne) {
  ActionSettings settings;
  for (const UndercutReport& noted : plan_of(angle_with_pockets(10, 10)).plan.undercuts)
    settings.pins.push_back({noted.point, noted.undercut.area, ActionKind::slide});
  const Planned planned = plan_of(angle_with_pockets(10, 10), settings);
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  ASSERT_EQ(planned.plan.unreleased.size(), 1U);
  const std::size_t left = planned.plan.unreleased.front();
  EXPECT_NEAR(planned.plan.unreleased_area, planned.plan.undercuts[left].undercut.area, 1e-6);
  ASSERT_EQ(planned.plan.rejected.size(), 1U);
  const RejectedAction& rejected = planned.plan.rejected.front();
  EXPECT_EQ(rejected.undercut, left);
  EXPECT_EQ(rejected.kind, ActionKind::slide);
  EXPECT_EQ(rejected.reason, RejectReason::hits_body);
  EXPECT_GT(rejected.depth, 1.0) << "a square of 8 and more";
  const ActionsReport report{*planned.model, planned.result, settings, planned.plan};
  const nlohmann::ordered_json json = actions_json(report)["rejected"][0];
  EXPECT_EQ(json["reason"], "its body hits another one");
  EXPECT_EQ(json["depth"], rejected.depth);
  EXPECT_EQ(json["when"], stage_text(rejected.when));
  EXPECT_TRUE(json["room"].is_null());
  EXPECT_TRUE(rejected_text(*planned.model, planned.plan).starts_with("Refused: slide for undercut "));
}

/// A lifter within the angle does without the way of a slide.
TEST(Meetings, AreAvoidedByAnotherKind) {
  const Planned planned = plan_of(angle_with_pockets(10, 10));
  ASSERT_EQ(actions_text(planned.plan), "1 slide, 1 lifter");
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_TRUE(action.meets.empty());
    if (action.kind == ActionKind::lifter) {
      EXPECT_NEAR(action.travel, 5.0, 0.01) << "as deep as the pocket";
    }
  }
  EXPECT_TRUE(planned.plan.optimal);
}

/// A plate with two slanted holes, square in section, whose axes cross 43 beyond its +x side; each becomes
/// wider to there by `draft_deg` on two sides. `which`: 1 has the first alone, 2 the second, 3 both.
TriangleMesh plate_with_slanted_holes(double draft_deg, int which) {
  constexpr double k_slant_deg = 35.0, k_thick = 20.0, k_half = 5.0, k_apart = 30.0;
  const glm::dvec3 low(-k_thick, -60, 0), high(0, 60, 30);
  const double slope = std::tan(glm::radians(k_slant_deg));
  SolidBuilder solid;
  std::vector<test::Loop> back, front;
  for (const int hole : {1, 2}) {
    if ((which & hole) == 0) continue;
    const double side = hole == 1 ? 1.0 : -1.0;
    const auto loop = [&](double x) {
      const double grown = (x + k_thick) * std::tan(glm::radians(draft_deg));
      const double y = side * (k_apart - x * slope), half = k_half + grown, rise = k_half + grown;
      return test::Loop{{x, y - half, 15 - rise},
                        {x, y + half, 15 - rise},
                        {x, y + half, 15 + rise},
                        {x, y - half, 15 + rise}};
    };
    back.push_back(loop(low.x));
    front.push_back(loop(high.x));
    test::Loop in_back = back.back(), in_front = front.back();
    std::ranges::reverse(in_back);
    std::ranges::reverse(in_front);
    solid.walls(in_back, in_front);
  }
  solid.box(low, high, {0, 1});
  solid.face(box_face(low, high, 0), back);
  solid.face(box_face(low, high, 1), front);
  return solid.mesh();
}

/// Each hole alone is pulled out of its wide end; both there would meet, so that one goes the dearer way.
TEST(Meetings, AreAvoidedByADearerSetOfSlides) {
  double careless = 0.0;
  for (const int hole : {1, 2}) {
    const Planned alone = plan_of(plate_with_slanted_holes(0.3, hole));
    ASSERT_EQ(actions_text(alone.plan), "1 slide");
    EXPECT_GT(alone.plan.actions[0].direction.x, 0.5) << "out of the wide end";
    careless += alone.plan.actions[0].direction.x;
  }
  const Planned both = plan_of(plate_with_slanted_holes(0.3, 3));
  ASSERT_EQ(actions_text(both.plan), "2 slides");
  double sum = 0.0;
  for (const SideAction& action : both.plan.actions) {
    EXPECT_TRUE(action.meets.empty());
    sum += action.direction.x;
  }
  EXPECT_NEAR(sum, 0.0, 0.02) << "one to either side";
  EXPECT_GT(careless, 1.0);
  EXPECT_TRUE(both.plan.optimal);
  EXPECT_TRUE(both.plan.unreleased.empty());
}

/// A pocket 4 deep and 8 high in an inner wall of a box.
struct WallPocket {
  int wall = 0;  // 0: at -x, 1: at +x, 2: at -y
  double from = 0.0, to = 0.0, bottom = 0.0;

  [[nodiscard]] std::pair<glm::dvec3, glm::dvec3> box(const glm::dvec2& inside) const {
    constexpr double k_deep = 4.0, k_high = 8.0;
    if (wall == 2) return {{from, -k_deep, bottom}, {to, 0.0, bottom + k_high}};
    const double x = wall == 0 ? -k_deep : inside.x;
    return {{x, from, bottom}, {x + k_deep, to, bottom + k_high}};
  }
};

/// A box open upward, `inside` wide, 35 deep, with pockets in its inner walls: only lifters release them.
TriangleMesh box_with_pockets(const glm::dvec2& inside, const std::vector<WallPocket>& pockets) {
  constexpr double k_wall = 10.0, k_floor = 5.0, k_top = 40.0;
  SolidBuilder solid;
  const glm::dvec3 low(-k_wall, -k_wall, 0), high(inside.x + k_wall, inside.y + k_wall, k_top);
  const glm::dvec3 in_low(0, 0, k_floor), in_high(inside.x, inside.y, k_top);
  std::array<std::vector<test::Loop>, 3> holes;
  for (const WallPocket& pocket : pockets) {
    const auto [from, to] = pocket.box(inside);
    const int open = pocket.wall == 1 ? 0 : pocket.wall + 1;
    solid.box(from, to, {open}, true);
    holes[static_cast<std::size_t>(pocket.wall)].push_back(box_face(from, to, open));
  }
  solid.box(low, high, {5});
  solid.face(box_face(low, high, 5), {box_face(in_low, in_high, 5)});
  solid.box(in_low, in_high, {0, 1, 2, 5}, true);
  solid.face(box_face({low.x, 0, k_floor}, {0, inside.y, k_top}, 1), holes[0]);
  solid.face(box_face({inside.x, 0, k_floor}, {high.x, inside.y, k_top}, 0), holes[1]);
  solid.face(box_face({0, low.y, k_floor}, {inside.x, 0, k_top}, 3), holes[2]);
  return solid.mesh();
}

/// How many pairs of its two lifters meet; each needs 4 of travel and the usual 3 of room.
std::size_t lifters_that_meet(const TriangleMesh& mesh) {
  const Planned planned = plan_of(mesh, without_stems());
  EXPECT_EQ(actions_text(planned.plan), "2 lifters");
  std::size_t number = 0;
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_NEAR(action.travel, 4.0, 0.01);
    EXPECT_TRUE(has_room(action)) << "each by itself";
    number += action.meets.size();
  }
  return number / 2;
}

TEST(Meetings, AreOfLiftersThatComeAtEachOther) {
  const auto facing = [](double wide, double height) {
    return lifters_that_meet(box_with_pockets({wide, 60}, {{0, 25, 35, 12}, {1, 25, 35, height}}));
  };
  EXPECT_EQ(facing(13.8, 12), 1U) << "two times 4 to travel and 3 of their own are wanted";
  EXPECT_EQ(facing(14.2, 12), 0U);
  EXPECT_EQ(facing(13.8, 25), 0U) << "one above the other";
}

TEST(Meetings, AreOfLiftersInACorner) {
  const auto at = [](double from) {
    return lifters_that_meet(box_with_pockets({50, 60}, {{0, from, from + 6, 12}, {2, from, from + 6, 12}}));
  };
  EXPECT_EQ(at(6.5), 1U) << "each comes to 7 beyond its wall";
  EXPECT_EQ(at(7.2), 0U);
}

/// The profiles, extruded, with a plate before either end.
TriangleMesh between_plates(const std::vector<Loop2>& profiles) {
  SolidBuilder solid;
  for (const Loop2& profile : profiles) solid.extrude(profile, {}, 8.0);
  solid.box({-100, -42, 0}, {100, -32, 60});
  solid.box({-100, 40, 0}, {100, 50, 60});
  return solid.mesh();
}

/// A trough with a groove 4 deep in either inner wall: a lifter can go across it or along it.
TriangleMesh grooved_trough(double wide) {
  const double far = wide + 10.0;
  const Loop2 profile = {{-10, 0},       {far, 0},   {far, 40}, {wide, 40}, {wide, 20}, {wide + 4, 20},
                         {wide + 4, 12}, {wide, 12}, {wide, 5}, {0, 5},     {0, 12},    {-4, 12},
                         {-4, 20},       {0, 20},    {0, 40},   {-10, 40}};
  return between_plates({profile});
}

/// Two walls 13.8 apart with facing grooves: from the one a lifter leaves upward, from the other downward.
TriangleMesh walls_of_both_halves() {
  const Loop2 wall = {{-10, 0}, {6.9, 0}, {6.9, 5}, {0, 5},  {0, 16},
                      {-4, 16}, {-4, 24}, {0, 24},  {0, 40}, {-10, 40}};
  Loop2 turned;
  for (const glm::dvec2& corner : wall) turned.emplace_back(13.8 - corner.x, 40.0 - corner.y);
  return between_plates({wall, turned});
}

TEST(Meetings, AreNoneOfLiftersOfDifferentHalves) {
  const Planned planned = plan_of(walls_of_both_halves(), without_stems());
  ASSERT_EQ(actions_text(planned.plan), "2 lifters");
  EXPECT_NE(planned.plan.actions[0].core_side, planned.plan.actions[1].core_side);
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_GT(std::abs(action.direction.x), 0.9) << "toward the other, although they would come at it";
    EXPECT_TRUE(action.meets.empty());
  }
}

TEST(Meetings, OfLiftersAreAvoidedAlongTheWall) {
  for (const bool near : {false, true}) {
    const Planned planned = plan_of(grooved_trough(near ? 12.0 : 16.0), without_stems());
    ASSERT_EQ(actions_text(planned.plan), "2 lifters");
    std::size_t along = 0;
    for (const SideAction& action : planned.plan.actions) {
      EXPECT_TRUE(action.meets.empty());
      along += std::abs(action.direction.y) > 0.5 ? 1 : 0;
    }
    EXPECT_EQ(along > 0, near);
    EXPECT_TRUE(planned.plan.optimal);
  }
}

TEST(Meetings, OfLiftersAreToldAsSuch) {
  const ActionSettings settings = without_stems();
  const Planned planned = plan_of(box_with_pockets({12, 60}, {{0, 25, 35, 12}, {1, 25, 35, 12}}), settings);
  EXPECT_EQ(meetings_text(planned.plan),
            "The paths of lifters cross, and no alternative was found: rows 1 and 2.");
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
