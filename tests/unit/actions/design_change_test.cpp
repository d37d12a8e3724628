// What to change so that an undercut is free: by formula, and the part changed as suggested has it no more.
#include "actions/design_change.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

std::vector<DesignChange> changes_of(const Planned& planned) {
  return find_changes(*planned.model, planned.result, {}, planned.plan, Progress());
}

struct Span2 {
  glm::dvec3 low{1e9}, high{-1e9};
};
Span2 box_of(const UndercutWindow& window) {
  Span2 box;
  for (const auto& loop : window.loops) {
    for (const glm::dvec3& point : loop) {
      box.low = glm::min(box.low, point);
      box.high = glm::max(box.high, point);
    }
  }
  return box;
}

/// A slot open above whose wings reach under both lips.
struct TSlot {
  double length = 30.0, lip = 5.0, half = 6.0, wing = 4.0;
  [[nodiscard]] TriangleMesh mesh() const {
    const double middle = 20.0, out = half + wing;
    return block_with_cavity({{middle - half, 20},
                              {middle - half, 20 - lip},
                              {middle - out, 20 - lip},
                              {middle - out, 8},
                              {middle + out, 8},
                              {middle + out, 20 - lip},
                              {middle + half, 20 - lip},
                              {middle + half, 20}},
                             {40, 20}, length);
  }
};

TEST(DesignChange, OfATSlotAreItsLips) {
  const TSlot slot;
  const Planned planned = plan_of(slot.mesh());
  ASSERT_EQ(planned.plan.undercuts.size(), 2U);
  const auto changes = changes_of(planned);
  ASSERT_EQ(changes.size(), 2U);
  const double tolerance = 1e-3 * planned.model->frame.diagonal;
  std::vector<Span2> windows;
  for (const DesignChange& change : changes) {
    ASSERT_TRUE(change.depth && change.direction);
    EXPECT_NEAR(*change.depth, slot.wing, tolerance);
    EXPECT_NEAR(std::abs(change.direction->x), 1.0, 1e-3);
    ASSERT_TRUE(change.window);
    EXPECT_TRUE(change.window->core_side) << "five of the lip rather than eight of the floor";
    EXPECT_NEAR(change.window->area, slot.wing * slot.length, 1e-3 * slot.wing * slot.length);
    EXPECT_NEAR(change.window->least_thickness, slot.lip, tolerance);
    EXPECT_NEAR(change.window->thickness, slot.lip, tolerance);
    EXPECT_NEAR(change.window->place.z, 20.0, tolerance);
    EXPECT_FALSE(change.window->through.empty());
    ASSERT_EQ(change.window->loops.size(), 1U);
    EXPECT_EQ(change.window->loops[0].size(), 4U);
    windows.push_back(box_of(*change.window));
  }
  // Both windows cut through: a pocket with upright walls.
  const double left = std::min(windows[0].low.x, windows[1].low.x),
               right = std::max(windows[0].high.x, windows[1].high.x);
  const Planned open =
      plan_of(block_with_cavity({{left, 20}, {left, 8}, {right, 8}, {right, 20}}, {40, 20}, slot.length));
  EXPECT_TRUE(open.plan.undercuts.empty());
  EXPECT_LT(open.result.areas[Region::undercut], 1e-9);
  // One of them: the other's undercut alone is left.
  const Planned half = plan_of(block_with_cavity(
      {{left, 20}, {left, 8}, {30, 8}, {30, 15}, {26, 15}, {26, 20}}, {40, 20}, slot.length));
  EXPECT_EQ(half.plan.undercuts.size(), 1U);
  // The lips cut back by less than the depth leave it.
  TSlot shorter = slot;
  shorter.half += 0.9 * *changes[0].depth;
  shorter.wing -= 0.9 * *changes[0].depth;
  EXPECT_EQ(plan_of(shorter.mesh()).plan.undercuts.size(), 2U);
}

/// A block with a round hole through it along y, `under` and `over` it so much material.
TriangleMesh block_with_bore(double under, double over, double radius, double length) {
  test::Loop2 hole = regular_polygon(32, radius);
  for (glm::dvec2& point : hole) point += glm::dvec2(20.0, under + radius);
  SolidBuilder solid;
  const double high = under + 2.0 * radius + over;
  solid.extrude({{0, 0}, {40, 0}, {40, high}, {0, high}}, {hole}, length);
  return solid.mesh();
}

TEST(DesignChange, OfASideHoleIsAWindowAsWideAsIt) {
  constexpr double k_radius = 5.0, k_length = 30.0;
  for (const bool up : {true, false}) {
    const double over = up ? 3.0 : 9.0, under = up ? 9.0 : 3.0;
    const Planned planned = plan_of(block_with_bore(under, over, k_radius, k_length));
    ASSERT_EQ(planned.plan.undercuts.size(), 1U);
    const auto changes = changes_of(planned);
    const double tolerance = 1e-3 * planned.model->frame.diagonal;
    ASSERT_TRUE(changes[0].window);
    const UndercutWindow& window = *changes[0].window;
    EXPECT_EQ(window.core_side, up) << "where less is in the way";
    EXPECT_NEAR(window.area, 2.0 * k_radius * k_length, 1e-3 * 2.0 * k_radius * k_length);
    EXPECT_NEAR(window.least_thickness, 3.0, 2e-2 * k_radius) << "over its crest";
    EXPECT_LE(window.thickness, 3.0 + k_radius + tolerance);
    EXPECT_NEAR(window.place.z, up ? under + 2.0 * k_radius + over : 0.0, tolerance);
    ASSERT_TRUE(changes[0].depth);
    EXPECT_NEAR(*changes[0].depth, k_length, 2.0 * tolerance) << "out along its axis";
    // Cut through: a groove with upright walls.
    const Span2 box = box_of(window);
    const double high = under + 2.0 * k_radius + over, middle = under + k_radius;
    test::Loop2 profile = {{0, 0}};
    const auto arc = [&](double from_deg, double sense) {
      for (int k = 0; k <= 16; ++k) {
        const double angle = glm::radians(from_deg + sense * 180.0 * k / 16);
        glm::dvec2 at(20.0 + k_radius * std::cos(angle), middle + k_radius * std::sin(angle));
        if (k == 0 || k == 16) at.x = at.x > 20.0 ? box.high.x : box.low.x;
        profile.push_back(at);
      }
    };
    if (up) {
      profile.insert(profile.end(), {{40, 0}, {40, high}, {box.high.x, high}});
      arc(0.0, -1.0);
      profile.insert(profile.end(), {{box.low.x, high}, {0, high}});
    } else {
      profile.push_back({box.low.x, 0});
      arc(180.0, -1.0);
      profile.insert(profile.end(), {{box.high.x, 0}, {40, 0}, {40, high}, {0, high}});
    }
    SolidBuilder solid;
    solid.extrude(profile, {}, k_length);
    const Planned open = plan_of(solid.mesh());
    EXPECT_TRUE(open.plan.undercuts.empty());
    EXPECT_LT(open.result.areas[Region::undercut], 1e-6 * open.result.total_area);
  }
}

/// A plate of `plate` with a hook of `ledge` under it, whose catch is 2 thick.
TriangleMesh lid_with_hook(double plate, double ledge) {
  test::Loop2 profile = {{0, 10}, {10, 10}, {10, 2}};
  if (ledge > 0.0) {
    profile.insert(profile.end(), {{12 + ledge, 2}, {12 + ledge, 4}, {12, 4}, {12, 10}});
  } else {
    profile.insert(profile.end(), {{12, 2}, {12, 10}});
  }
  profile.insert(profile.end(), {{40, 10}, {40, 10 + plate}, {0, 10 + plate}});
  SolidBuilder solid;
  solid.extrude(profile, {}, 30.0);
  return solid.mesh();
}

TEST(DesignChange, OfAHookUnderALidIsItsLedgeOrAWindowInTheLid) {
  constexpr double k_ledge = 3.0;
  const Planned planned = plan_of(lid_with_hook(4.0, k_ledge));
  ASSERT_EQ(planned.plan.undercuts.size(), 1U);
  const auto changes = changes_of(planned);
  const double tolerance = 1e-3 * planned.model->frame.diagonal;
  ASSERT_TRUE(changes[0].depth && changes[0].direction && changes[0].window);
  EXPECT_NEAR(*changes[0].depth, k_ledge, tolerance);
  EXPECT_GT(changes[0].direction->x, 1.0 - 1e-3);
  EXPECT_FALSE(changes[0].window->core_side);
  EXPECT_NEAR(changes[0].window->area, k_ledge * 30.0, 0.1);
  EXPECT_NEAR(changes[0].window->thickness, 2.0, tolerance);
  EXPECT_TRUE(plan_of(lid_with_hook(4.0, k_ledge - *changes[0].depth)).plan.undercuts.empty());
  EXPECT_EQ(plan_of(lid_with_hook(4.0, 0.1 * *changes[0].depth)).plan.undercuts.size(), 1U);
  // Through a lid that is thinner than the catch.
  const auto thin = changes_of(plan_of(lid_with_hook(1.0, k_ledge)));
  ASSERT_TRUE(thin.at(0).window);
  EXPECT_TRUE(thin[0].window->core_side);
  EXPECT_NEAR(thin[0].window->thickness, 1.0, tolerance);
  EXPECT_NEAR(thin[0].window->place.z, 11.0, tolerance);
}

TEST(DesignChange, OfAClosedVoidIsAWindowAlone) {
  SolidBuilder solid;
  solid.box({0, 0, 0}, {40, 40, 40});
  solid.box({10, 12, 20}, {30, 28, 34}, {}, true);
  const Planned planned = plan_of(solid.mesh());
  ASSERT_EQ(planned.plan.undercuts.size(), 1U);
  const auto changes = changes_of(planned);
  EXPECT_FALSE(changes[0].depth);
  EXPECT_FALSE(changes[0].direction);
  ASSERT_TRUE(changes[0].window);
  EXPECT_TRUE(changes[0].window->core_side);
  EXPECT_NEAR(changes[0].window->area, 20.0 * 16.0, 1e-3);
  EXPECT_NEAR(changes[0].window->thickness, 6.0, 1e-3);
}

}  // namespace
}  // namespace moldlight
