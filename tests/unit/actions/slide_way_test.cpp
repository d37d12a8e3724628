// Which way out a slide takes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/box_pile.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// Each window could be pulled through the box and the window across from it, too.
TEST(SlideWay, OfVentsInFourWallsIsOutwards) {
  for (const glm::dvec2& size : {glm::dvec2(60, 90), glm::dvec2(30, 30)}) {
    const Planned planned = plan_of(box_with_vents(size));
    SCOPED_TRACE(size.x);
    ASSERT_EQ(actions_text(planned.plan), "4 slides");
    for (const SideAction& action : planned.plan.actions) {
      ASSERT_EQ(action.undercuts.size(), 1U);
      const Undercut& window = planned.plan.undercuts[action.undercuts[0]].undercut;
      const glm::dvec2 outward(window.centre - planned.model->frame.center);
      EXPECT_NEAR(glm::dot(glm::dvec2(action.direction), glm::normalize(outward)), 1.0, 1e-9);
      EXPECT_NEAR(action.travel, k_vented_wall + 3.0, 1e-3);
      EXPECT_TRUE(action.meets.empty());
    }
  }
}

/// The window aside may share a slide with either of the others; these two still not with each other.
TEST(SlideWay, OfOppositeWindowsIsOutwardsThoughAThirdIsBesideBoth) {
  const Planned planned = plan_of(box_with_a_window_aside());
  ASSERT_EQ(actions_text(planned.plan), "2 slides");
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_EQ(action.undercuts.size(), action.direction.x > 0.0 ? 2U : 1U);
    EXPECT_NEAR(std::abs(action.direction.x), 1.0, 1e-9);
    EXPECT_NEAR(action.travel, 2.0 + 3.0, 1e-3);
  }
}

/// A block with a round bore through it along x, and one of the same width from there out along y.
TriangleMesh block_with_crossing_bores() {
  constexpr int k_strips = 12;  // of half a bore
  constexpr double k_radius = 6.0;
  const glm::dvec3 low(-30, -10, -10), high(30, 20, 10);
  const auto wide = [](int k) {
    return k % k_strips == 0 ? 0.0 : k_radius * std::sin(std::numbers::pi * k / k_strips);
  };
  const auto at = [](int k) { return -k_radius * std::cos(std::numbers::pi * k / k_strips); };
  SolidBuilder solid;
  const auto wall = [&](test::Loop loop, const glm::dvec3& axis_point) {
    if (glm::dot(glm::cross(loop[1] - loop[0], loop[2] - loop[0]), axis_point - loop[0]) < 0.0)
      std::ranges::reverse(loop);
    solid.face(loop);
  };
  const auto mouth = [&](const auto& corner) {
    test::Loop loop;
    for (int k = 0; k <= k_strips; ++k) loop.push_back(corner(wide(k), at(k)));
    for (int k = k_strips - 1; k > 0; --k) loop.push_back(corner(-wide(k), at(k)));
    return loop;
  };
  for (int k = 0; k < k_strips; ++k) {
    const double a = wide(k), b = wide(k + 1), from = at(k), to = at(k + 1);
    const glm::dvec3 inside(0, 0, 0.5 * (from + to));
    for (const double side : {-1.0, 1.0}) {
      const double end = side * high.x;
      wall({{end, -a, from}, {0, -a, from}, {0, -b, to}, {end, -b, to}}, inside);
      wall({{end, a, from}, {side * a, a, from}, {side * b, b, to}, {end, b, to}}, inside);
      wall({{side * a, a, from}, {side * a, high.y, from}, {side * b, high.y, to}, {side * b, b, to}},
           inside);
    }
  }
  solid.box(low, high, {0, 1, 3});
  for (const int face : {0, 1})
    solid.face(box_face(low, high, face),
               {mouth([&](double y, double z) { return glm::dvec3(face == 0 ? low.x : high.x, y, z); })});
  solid.face(box_face(low, high, 3), {mouth([&](double x, double z) { return glm::dvec3(x, high.y, z); })});
  return solid.mesh();
}

/// The steel in the one ends where the other passes: neither fills what the other does.
TEST(SlideWay, OfBoresThatCrossIsOutThroughEach) {
  for (const bool mixed : {false, true}) {
    const TriangleMesh block = block_with_crossing_bores();
    const Planned planned = plan_of(mixed ? test::permuted(block, 3) : block);
    ASSERT_EQ(actions_text(planned.plan), "2 slides");
    EXPECT_EQ(planned.plan.unreleased_area, 0.0);
    double along = 0.0, aside = 0.0;
    for (const SideAction& action : planned.plan.actions) {
      ASSERT_TRUE(action.body);
      EXPECT_FALSE(action.body->hit);
      along = std::max(along, std::abs(action.direction.x));
      aside = std::max(aside, action.direction.y);
    }
    EXPECT_NEAR(along, 1.0, 1e-9);
    EXPECT_NEAR(aside, 1.0, 1e-9);
  }
}

/// Two windows in either of two walls, across from each other, which a core stands between.
TEST(SlideWay, OfWindowsAcrossFromEachOtherIsOneSlideAWall) {
  const glm::dvec3 low(0, 0, 0), high(30, 14, 8), inner_low(0, 1, 1), inner_high(30, 13, 7);
  SolidBuilder solid;
  solid.box(low, high, {0, 1, 4, 5});
  solid.box(inner_low, inner_high, {0, 1, 4, 5}, true);
  for (const int end : {0, 1})
    solid.face(box_face(low, high, end), {box_face({low.x, 1, 1}, {high.x, 13, 7}, end)});
  for (const int wall : {4, 5}) {
    const double from = wall == 4 ? 0.0 : 7.0;
    std::vector<test::Loop> outer, inner;
    for (const double y : {3.0, 8.5}) {
      const glm::dvec3 window_low(8, y, from), window_high(10.5, y + 2.5, from + 1.0);
      outer.push_back(box_face(window_low, window_high, wall));
      inner.push_back(box_face(window_low, window_high, 9 - wall));
      solid.box(window_low, window_high, {4, 5}, true);
    }
    solid.face(box_face(low, high, wall), outer);
    test::Loop inside = box_face(inner_low, inner_high, wall);
    std::ranges::reverse(inside);
    solid.face(inside, inner);
  }
  const Planned planned = plan_of(solid.mesh(), {}, {1, 0, 0});
  ASSERT_EQ(actions_text(planned.plan), "2 slides");
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_EQ(action.undercuts.size(), 2U);
    EXPECT_NEAR(std::abs(action.direction.z), 1.0, 1e-9);
    EXPECT_NEAR(action.travel, 1.0 + 3.0, 1e-3);
  }
}

/// A hole in the one wall of a long plate leaves by the wall's side, not over the plate.
TEST(SlideWay, OfAHoleInAWallIsTheShorterOne) {
  for (const bool at_far_end : {false, true}) {
    const glm::dvec3 hole_low(0, 15, 12), hole_high(5, 25, 22);
    SolidBuilder solid;
    const Loop2 side = {{0, 0}, {100, 0}, {100, 5}, {5, 5}, {5, 30}, {0, 30}};
    test::Loop near, far;
    for (const glm::dvec2& corner : side) near.emplace_back(corner.x, 0.0, corner.y);
    for (auto corner = side.rbegin(); corner != side.rend(); ++corner)
      far.emplace_back(corner->x, 40.0, corner->y);
    solid.face(near);
    solid.face(far);
    solid.box({0, 0, 0}, {100, 40, 5}, {0, 2, 3, 5});
    solid.face({{5, 0, 5}, {100, 0, 5}, {100, 40, 5}, {5, 40, 5}});
    solid.face({{0, 0, 30}, {5, 0, 30}, {5, 40, 30}, {0, 40, 30}});
    solid.face(box_face({0, 0, 0}, {5, 40, 30}, 0), {box_face(hole_low, hole_high, 0)});
    solid.face(box_face({0, 0, 5}, {5, 40, 30}, 1), {box_face(hole_low, hole_high, 1)});
    solid.box(hole_low, hole_high, {0, 1}, true);
    const glm::dquat turn = glm::angleAxis(at_far_end ? glm::radians(180.0) : 0.0, glm::dvec3(0, 0, 1));
    const Planned planned = plan_of(test::rotated(solid.mesh(), turn));
    ASSERT_EQ(actions_text(planned.plan), "1 slide");
    EXPECT_NEAR(planned.plan.actions[0].direction.x, at_far_end ? 1.0 : -1.0, 1e-9);
    EXPECT_NEAR(planned.plan.actions[0].travel, 5.0 + 3.0, 1e-3);
  }
}

/// Upright ribs on a plate, the first `bored` of them with a square hole in line.
TriangleMesh ribs_with_holes(int ribs, int bored, double thick = 2.0) {
  constexpr double k_apart = 8.0, k_first = 4.0, k_width = 30.0;
  const auto begin = [](int rib) { return k_first + k_apart * rib; };
  const double length = begin(ribs) + k_first;
  Loop2 side = {{0, 0}, {length, 0}, {length, 3}};
  for (int rib = ribs - 1; rib >= 0; --rib) {
    const double from = begin(rib), to = from + thick;
    for (const glm::dvec2& corner : {glm::dvec2(to, 3), {to, 18}, {from, 18}, {from, 3}})
      side.push_back(corner);
  }
  side.emplace_back(0, 3);
  SolidBuilder solid;
  test::Loop near, far;
  for (const glm::dvec2& corner : side) near.emplace_back(corner.x, 0.0, corner.y);
  for (auto corner = side.rbegin(); corner != side.rend(); ++corner)
    far.emplace_back(corner->x, k_width, corner->y);
  solid.face(near);
  solid.face(far);
  const double last = begin(bored - 1) + thick;
  for (std::size_t k = 0; k < side.size(); ++k) {
    const glm::dvec2 &a = side[k], &b = side[(k + 1) % side.size()];
    std::vector<test::Loop> holes;
    if (a.x == b.x && a.x > 0.0 && a.x <= last)
      holes.push_back({{a.x, 12, 8}, {a.x, 18, 8}, {a.x, 18, 14}, {a.x, 12, 14}});
    solid.face({{a.x, 0, a.y}, {a.x, k_width, a.y}, {b.x, k_width, b.y}, {b.x, 0, b.y}}, holes);
  }
  for (int rib = 0; rib < bored; ++rib)
    solid.box({begin(rib), 12, 8}, {begin(rib) + thick, 18, 14}, {0, 1}, true);
  return solid.mesh();
}

/// Not one a rib, each through the place of the one before.
TEST(SlideWay, OfHolesInLineIsOneSlideFromEitherSide) {
  const Planned planned = plan_of(ribs_with_holes(6, 6));
  ASSERT_EQ(actions_text(planned.plan), "2 slides");
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_EQ(action.undercuts.size(), 3U);
    EXPECT_NEAR(std::abs(action.direction.x), 1.0, 1e-9);
    EXPECT_NEAR(action.travel, 18.0 + 3.0, 1e-3) << "past the outermost rib";
  }
  EXPECT_LT(planned.plan.actions[0].direction.x * planned.plan.actions[1].direction.x, 0.0);
}

TEST(SlideWay, OfHolesInLineBeforeAClosedRibIsOneSlide) {
  const Planned planned = plan_of(ribs_with_holes(5, 4));
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  EXPECT_EQ(planned.plan.actions[0].undercuts.size(), 4U);
  EXPECT_NEAR(planned.plan.actions[0].direction.x, -1.0, 1e-9);
  EXPECT_NEAR(planned.plan.actions[0].travel, 26.0 + 3.0, 1e-3);
  ASSERT_TRUE(planned.plan.actions[0].core_pin);
  EXPECT_NEAR(planned.plan.actions[0].core_pin->length, 26.0, 0.5) << "through all of them";
}

/// From each to the next the gap is no wider than they are: a pin goes through all, as through a hinge.
TEST(SlideWay, OfKnucklesIsOnePin) {
  const Planned planned = plan_of(ribs_with_holes(3, 3, 4.0));
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  EXPECT_EQ(planned.plan.actions[0].undercuts.size(), 3U);
  EXPECT_NEAR(planned.plan.actions[0].travel, 20.0 + 3.0, 1e-3);
}

/// An open box with ledges on the inside of its left wall, one above the other; the right wall may be open
/// across from them.
TriangleMesh box_with_ledges(int ledges, bool open) {
  test::BoxPile pile{
      .planes = {{{0, 2, 4, 58, 60}, {0, 2, 13, 15, 25, 27, 38, 40}, {0, 2, 10, 12, 18, 20, 28}}},
      .filled = {}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 7; ++j) {
      for (int k = 0; k < 6; ++k) {
        const bool wall = k == 0 || i == 0 || (i == 3 && !(open && j > 1 && j < 5)) || j == 0 || j == 6;
        const bool ledge = i == 1 && j == 3 && (k == 2 || (k == 4 && ledges > 1));
        pile.filled.push_back(wall || ledge);
      }
    }
  }
  return test::pile_mesh(pile, 1);
}

/// Not a slide across the whole box, above its bottom, where the core has to be.
TEST(SlideWay, OutOfABoxIsNotAcrossItWhereALifterWouldDo) {
  const Planned planned = plan_of(box_with_ledges(1, true));
  ASSERT_EQ(actions_text(planned.plan), "1 lifter");
  EXPECT_NEAR(planned.plan.actions[0].direction.x, 1.0, 1e-9);
  EXPECT_NEAR(planned.plan.actions[0].travel, 2.0, 1e-3);
  // Where lifters cost more, it is.
  ActionSettings slides_alone;
  slides_alone.prices[static_cast<std::size_t>(ActionKind::lifter)] = 2.0;
  EXPECT_EQ(actions_text(plan_of(box_with_ledges(1, true), slides_alone).plan), "1 slide");
}

/// The stem of a lifter for the lower ledge alone would go through the upper one's head.
TEST(SlideWay, UnderLedgesAboveEachOtherIsThatOfOneLifter) {
  const Planned planned = plan_of(box_with_ledges(2, false));
  ASSERT_EQ(actions_text(planned.plan), "1 lifter");
  EXPECT_EQ(planned.plan.actions[0].undercuts.size(), planned.plan.undercuts.size());
  EXPECT_NEAR(planned.plan.actions[0].direction.x, 1.0, 1e-9);
}

/// Wherever its facets lie.
TEST(SlideWay, OfASpoolIsTwoOppositeSlidesOnAnAxis) {
  for (const auto& [sides, turn_deg] : {std::pair(48, 0.0), std::pair(60, 1.3), std::pair(90, 24.0)}) {
    const Planned planned = plan_of(spool(sides, turn_deg));
    SCOPED_TRACE(sides);
    ASSERT_EQ(actions_text(planned.plan), "2 slides");
    const glm::dvec3 &one = planned.plan.actions[0].direction, &other = planned.plan.actions[1].direction;
    EXPECT_LT(glm::distance(one, -other), 1e-9);
    EXPECT_NEAR(std::max(std::abs(one.x), std::abs(one.y)), 1.0, 1e-9);
    EXPECT_NEAR(planned.plan.actions[0].travel, planned.plan.actions[1].travel, 1.0) << "a facet's width";
    EXPECT_LT(planned.plan.unreleased_area, 1e-9);
  }
}

/// A hole of 14 that leans by 0.1 degrees is 0.02 in the way of a slide along the part's axis, less than
/// twice the lateral tolerance; by 0.4 degrees it is 0.1, and the body of such a slide would hit.
TEST(SlideWay, LiesOnThePartsAxisUnlessItsBodyHits) {
  for (const double azimuth_deg : {0.0, 31.0}) {
    for (const double lean_deg : {0.0, 0.1, 0.4, 0.8, 1.5, 5.0}) {
      const Planned planned = plan_of(laid(block_with_hole({.lean_deg = lean_deg}), azimuth_deg));
      ASSERT_EQ(actions_text(planned.plan), "1 slide") << lean_deg;
      const glm::dvec3& way = planned.plan.actions[0].direction;
      const double off_deg = glm::degrees(std::atan2(way.y, way.x)) - azimuth_deg;
      EXPECT_NEAR(off_deg, lean_deg < 0.2 ? 0.0 : lean_deg, 1e-3) << lean_deg;
    }
  }
}

/// The bore belongs to one of two opposite slides, which meet at its end.
TEST(SlideWay, OppositeSlidesMeetAtTheEndOfABore) {
  const Planned planned = plan_of(block_with_pockets_and_bore(), {}, {1, 0, 0});
  EXPECT_EQ(actions_text(planned.plan), "2 slides");
  EXPECT_EQ(planned.plan.unreleased_area, 0.0);
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_NEAR(std::abs(action.direction.z), 1.0, 1e-12);
    ASSERT_TRUE(action.body);
    EXPECT_FALSE(action.body->hit);
  }
}

}  // namespace
}  // namespace moldlight
