// Undercuts of known release in random sizes, tessellations, units and places.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"
#include "support/random.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// Where a part is put: its size by powers of ten, and how far it lies from the origin.
struct Setting {
  double scale = 1.0;
  glm::dvec3 offset{0.0};  // in sizes before the scale
  bool as_file = false;    // coordinates in single precision
};

Setting random_setting(test::Random& random) {
  constexpr double k_scales[] = {1e-3, 1.0, 1e3};
  Setting setting;
  setting.scale = k_scales[random.below(3)];
  if (random.chance(0.5)) setting.offset = random.in_cube(1e4);
  return setting;
}

/// Without clearance, which is a length of its own, and with slides that reach as far, and lifters that are
/// as thick, as they would be in size 1.
Planned plan_in(const Setting& setting, const TriangleMesh& mesh) {
  ActionSettings settings;
  settings.clearance_mm = 0.0;
  settings.least_travel_mm *= setting.scale;
  settings.lifter_room_mm *= setting.scale;
  settings.lifter_section_mm *= setting.scale;
  settings.pin_diameter_mm *= setting.scale;
  settings.bundle_across_mm *= setting.scale;
  settings.bundle_along_mm *= setting.scale;
  TriangleMesh put = test::scaled(test::translated(mesh, setting.offset), setting.scale);
  if (setting.as_file) put = test::rounded_to_float(std::move(put));
  return plan_of(put, settings);
}

TEST(Variety, OfSideHolesIsASlideAlongTheAxis) {
  test::Random random(71);
  for (int k = 0; k < 40; ++k) {
    const double azimuth = random.between(0.0, 360.0);
    Hole hole{.draft_deg = random.chance(0.5) ? 0.0 : random.between(0.2, 6.0),
              .through = random.chance(0.5),
              .depth = random.between(1.0, 20.0),
              .radius = random.between(3.0, 10.5),
              .sides = static_cast<int>(8 + random.below(100))};
    hole.turn_deg = azimuth;
    const Setting setting = random_setting(random);
    const Planned planned = plan_in(setting, laid(block_with_hole(hole), azimuth));
    SCOPED_TRACE(::testing::Message() << k << ": azimuth " << azimuth << ", draft " << hole.draft_deg << ", "
                                      << (hole.through ? "through" : "blind") << ", depth " << hole.depth
                                      << ", radius " << hole.radius << ", sides " << hole.sides << ", scale "
                                      << setting.scale << ", off " << glm::length(setting.offset));
    ASSERT_EQ(actions_text(planned.plan), "1 slide");
    const SideAction& action = planned.plan.actions.front();
    const glm::dvec3 axis(std::cos(glm::radians(azimuth)), std::sin(glm::radians(azimuth)), 0.0);
    EXPECT_LT(line_angle_deg(action.direction, axis), 0.01);
    const double depth = hole.through ? 22.0 : hole.depth;
    EXPECT_NEAR(action.travel, depth * setting.scale, 1e-3 * planned.model->frame.diagonal);
    EXPECT_TRUE(planned.plan.unreleased.empty());
    // Few sides: none of them need stand upright, where a turn is bounded.
    if (hole.sides < 48) continue;
    EXPECT_NEAR(action.interval.to_deg, hole.draft_deg + k_tau_deg, 0.05);
    EXPECT_NEAR(action.interval.from_deg, -hole.draft_deg - k_tau_deg, 0.05);
  }
}

/// A file in single precision, far off, has corners that are off by a 1000th of its unit.
TEST(Variety, OfSideHolesInFilesFarOffIsASlideNearTheAxis) {
  test::Random random(72);
  for (int k = 0; k < 12; ++k) {
    const double azimuth = random.between(0.0, 360.0);
    const Hole hole{.through = k % 2 == 0, .depth = 12.0, .sides = 40};
    const Planned planned =
        plan_in({.offset = random.in_cube(1e4), .as_file = true}, laid(block_with_hole(hole), azimuth));
    ASSERT_EQ(actions_text(planned.plan), "1 slide") << k;
    const glm::dvec3 axis(std::cos(glm::radians(azimuth)), std::sin(glm::radians(azimuth)), 0.0);
    EXPECT_LT(line_angle_deg(planned.plan.actions.front().direction, axis), 0.1) << k;
  }
}

TEST(Variety, OfTSlotsIsALifterForEachWing) {
  test::Random random(73);
  for (int k = 0; k < 16; ++k) {
    const double overhang = random.between(1.0, 4.0), half = overhang + random.between(7.0, 10.0);
    const double floor = random.between(2.0, 6.0), ceiling = floor + random.between(2.0, 7.0);
    const Loop2 profile = {{20 - half, 20},
                           {20 - half, ceiling},
                           {20 - half - overhang, ceiling},
                           {20 - half - overhang, floor},
                           {20 + half + overhang, floor},
                           {20 + half + overhang, ceiling},
                           {20 + half, ceiling},
                           {20 + half, 20}};
    const Setting setting = random_setting(random);
    const Planned planned =
        plan_in(setting, block_with_cavity(profile, {40, 20}, random.between(10.0, 60.0)));
    ASSERT_EQ(actions_text(planned.plan), "2 lifters") << k << " " << overhang << " " << half;
    for (const SideAction& action : planned.plan.actions) {
      EXPECT_NEAR(std::abs(action.direction.x), 1.0, 1e-6) << k;
      EXPECT_NEAR(action.travel, overhang * setting.scale, 1e-3 * planned.model->frame.diagonal) << k;
      EXPECT_NEAR(*action.stroke, action.travel / std::tan(glm::radians(8.0)), 1e-9 * *action.stroke);
    }
  }
}

/// Out from under the hook, or to either side of it where that is shorter.
TEST(Variety, OfHooksInABoxIsALifter) {
  test::Random random(74);
  for (int k = 0; k < 16; ++k) {
    const double hook = random.between(0.5, 10.0);
    const Setting setting = random_setting(random);
    const Planned planned = plan_in(setting, box_with_hook(hook));
    ASSERT_EQ(actions_text(planned.plan), "1 lifter") << k << " " << hook;
    const SideAction& lifter = planned.plan.actions[0];
    EXPECT_GT(hook < k_hook_width ? lifter.direction.x : std::abs(lifter.direction.y), 1.0 - 1e-6) << k;
    EXPECT_NEAR(lifter.travel, std::min(hook, k_hook_width) * setting.scale,
                1e-3 * planned.model->frame.diagonal)
        << k;
  }
}

TEST(Variety, OfDovetailsIsASlideAlongThem) {
  test::Random random(75);
  for (int k = 0; k < 16; ++k) {
    const double length = random.between(10.0, 80.0), neck = random.between(3.0, 8.0);
    const double foot = neck + random.between(1.0, 6.0), deep = random.between(3.0, 14.0);
    SolidBuilder solid;
    solid.extrude({{0, 0},
                   {40, 0},
                   {40, 20},
                   {20 + neck, 20},
                   {20 + foot, 20 - deep},
                   {20 - foot, 20 - deep},
                   {20 - neck, 20},
                   {0, 20}},
                  {}, length);
    const Setting setting = random_setting(random);
    const Planned planned = plan_in(setting, solid.mesh());
    ASSERT_EQ(actions_text(planned.plan), "1 slide") << k << " " << neck << " " << foot << " " << deep;
    EXPECT_NEAR(std::abs(planned.plan.actions[0].direction.y), 1.0, 1e-6) << k;
    EXPECT_NEAR(planned.plan.actions[0].travel, length * setting.scale, 1e-3 * planned.model->frame.diagonal)
        << k;
  }
}

}  // namespace
}  // namespace moldlight
