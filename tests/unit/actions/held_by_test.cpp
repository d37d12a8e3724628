// What actions are held by: stems of lifters, and pins that form holes.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "actions/actions_report.hpp"
#include "mesh/health.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// A hook of 3 in a box that leaves it no other way than straight ahead.
Planned hook_with(double ahead, double section_mm = ActionSettings().lifter_section_mm) {
  ActionSettings settings;
  settings.lifter_section_mm = section_mm;
  return plan_of(box_with_hook(3.0, ahead, 0.5), settings);
}

/// Each hook hides a sixth of the wall that both stand on: the wall is the core's, not a lifter's.
TEST(Lifter, HeadIsNoWiderThanTheHookThatItFrees) {
  const Planned planned = plan_of(box_with_hooks(3.0, 20.0, 40.0, {4.0, 26.0}));
  ASSERT_EQ(actions_text(planned.plan), "2 lifters");
  EXPECT_EQ(planned.plan.unreleased_area, 0.0);
  for (const SideAction& action : planned.plan.actions) {
    ASSERT_TRUE(action.body);
    EXPECT_FALSE(action.body->hit);
    Bounds box;
    for (const glm::dvec3& point : action.body->solid->vertices) box.add(point);
    EXPECT_NEAR(box.max.y - box.min.y, k_hook_width, 0.1);
  }
}

/// It stands beyond the hook, leans back beside it by 2 tan(8°) = 0.28, and travels by 3.
TEST(Stem, StandsBeforeAHookAsFarAsTheWallAcrossAllows) {
  for (const double section : {1.0, 3.0, 4.0}) {
    const double wanted = 3.0 + 0.28 + section;
    const double room = 3.0 + ActionSettings().lifter_room_mm;
    const Planned roomy = hook_with(std::max(wanted, room) + 0.25 * section + 0.1, section);
    ASSERT_EQ(actions_text(roomy.plan), "1 lifter") << section;
    ASSERT_EQ(roomy.plan.actions[0].stems.size(), 1U);
    const Stem& stem = roomy.plan.actions[0].stems[0];
    EXPECT_DOUBLE_EQ(stem.width, section);
    EXPECT_NEAR(stem.way.x / stem.way.z, -std::tan(glm::radians(8.0)), 1e-9) << "against its travel";
    EXPECT_GT(stem.top.x - 0.5 * section, 2.0 + 3.0) << "before the hook";
    if (wanted - 0.1 < room) continue;
    const Planned narrow = hook_with(wanted - 0.1, section);
    EXPECT_EQ(actions_text(narrow.plan), "none") << section;
    ASSERT_FALSE(narrow.plan.rejected.empty());
    EXPECT_EQ(narrow.plan.rejected[0].reason, RejectReason::no_stem);
    EXPECT_NE(rejected_text(*narrow.model, narrow.plan).find("no room for its stem"), std::string::npos)
        << rejected_text(*narrow.model, narrow.plan);
  }
}

/// At 150 mm of stroke a lifter travels 2.88 mm at 1.1 degrees and 3.14 at 1.2.
TEST(Lifter, TravelsAsFarAsEjectorsDriveIt) {
  const auto at_angle = [](double angle_deg) {
    ActionSettings settings;
    settings.lifter_angle_deg = angle_deg;
    return plan_of(box_with_hook(3.0, 12.0, 0.5), settings);
  };
  EXPECT_EQ(actions_text(at_angle(1.2).plan), "1 lifter");
  const Planned steep = at_angle(1.1);
  EXPECT_EQ(actions_text(steep.plan), "none");
  ASSERT_FALSE(steep.plan.rejected.empty());
  EXPECT_EQ(steep.plan.rejected[0].reason, RejectReason::too_far);
  EXPECT_NE(rejected_text(*steep.model, steep.plan).find("farther than ejectors drive it"), std::string::npos)
      << rejected_text(*steep.model, steep.plan);
}

TEST(Stem, IsNotAskedForAtASectionOfNothing) {
  const Planned planned = hook_with(6.5, 0.0);
  ASSERT_EQ(actions_text(planned.plan), "1 lifter");
  EXPECT_TRUE(planned.plan.actions[0].stems.empty());
}

/// A slot whose wing goes 4 to one side under its roof: the stem goes up through the neck, where it leans by
/// 8 tan(8°) = 1.12, and back and forth there.
TEST(Stem, GoesThroughTheNeckOfASlot) {
  const auto with_neck = [](double neck) {
    const Loop2 profile = {{16, 20}, {16, 12}, {12, 12}, {12, 6}, {16 + neck, 6}, {16 + neck, 20}};
    return plan_of(block_with_cavity(profile, {60, 20}, 30.0));
  };
  const Planned narrow = with_neck(4.0 + 1.12 + 4.0 - 0.1);
  EXPECT_EQ(actions_text(narrow.plan), "none");
  ASSERT_FALSE(narrow.plan.rejected.empty());
  EXPECT_EQ(narrow.plan.rejected[0].reason, RejectReason::no_stem);
  const Planned wide = with_neck(4.0 + 1.12 + 4.0 + 1.1);
  ASSERT_EQ(actions_text(wide.plan), "1 lifter");
  EXPECT_NEAR(wide.plan.actions[0].travel, 4.0, 0.05);
}

/// Under the roof the lifter has all the room it needs; in the neck its stem must have it, too, as it
/// travels.
TEST(Stem, HasRoomInTheNeckWhereItTravels) {
  const auto with_neck = [](double neck) {
    const Loop2 profile = {{16, 20}, {16, 12}, {12, 12},        {12, 6},
                           {52, 6},  {52, 12}, {16 + neck, 12}, {16 + neck, 20}};
    return plan_of(block_with_cavity(profile, {60, 20}, 30.0)).plan;
  };
  const auto goes_ahead = [](const auto& action) {
    return action.kind == ActionKind::lifter && action.direction.x > 0.99;
  };
  const ActionPlan narrow = with_neck(4.0 + 1.12 + 4.0 - 0.1);
  EXPECT_EQ(std::ranges::count_if(narrow.actions, goes_ahead), 0);
  const auto refused = std::ranges::find_if(narrow.rejected, goes_ahead);
  ASSERT_NE(refused, narrow.rejected.end());
  EXPECT_EQ(refused->reason, RejectReason::no_stem) << reject_text(refused->reason);
  EXPECT_EQ(std::ranges::count_if(with_neck(4.0 + 1.12 + 4.0 + 1.1).actions, goes_ahead), 1);
}

TEST(Stem, IsPartOfTheBodyAndReachesOutOfTheMold) {
  const Planned planned = hook_with(12.0);
  ASSERT_EQ(actions_text(planned.plan), "1 lifter");
  ASSERT_TRUE(planned.plan.actions[0].body);
  const BodyFigures& body = *planned.plan.actions[0].body;
  EXPECT_FALSE(body.hit);
  EXPECT_EQ(connected_components(*body.solid).count, 2U) << "head and stem";
  Bounds box;
  for (const glm::dvec3& vertex : body.solid->vertices) box.add(vertex);
  EXPECT_GT(box.max.z, planned.model->health.bounds.max.z + 1.0);
  EXPECT_GT(body.volume, 16.0 * (box.max.z - 14.0)) << "4 by 4 from under the hook up";
}

TEST(CorePin, IsNoThinnerThanPinsMayBe) {
  for (const double diameter : {0.5, 0.9, 1.1, 3.0}) {
    const Hole hole{.depth = 3.0, .radius = 0.5 * diameter};
    const Planned planned = plan_of(laid(block_with_hole(hole), 0.0));
    EXPECT_EQ(actions_text(planned.plan), diameter < 1.0 ? "none" : "1 slide") << diameter;
    ASSERT_EQ(planned.plan.rejected.empty(), diameter >= 1.0) << diameter;
    if (diameter >= 1.0) continue;
    const RejectedAction& rejected = planned.plan.rejected[0];
    EXPECT_EQ(rejected.reason, RejectReason::thin_pin);
    EXPECT_NEAR(rejected.width, diameter, 0.02 * diameter);
    EXPECT_NEAR(std::abs(rejected.direction.x), 1.0, 0.02) << "along the hole";
    ActionSettings settings;
    settings.pin_diameter_mm = 0.9 * diameter;
    EXPECT_EQ(actions_text(plan_of(laid(block_with_hole(hole), 0.0), settings).plan), "1 slide");
    settings.pin_diameter_mm = 0.0;
    EXPECT_EQ(actions_text(plan_of(laid(block_with_hole(hole), 0.0), settings).plan), "1 slide");
  }
}

/// What the facets of a round hole take off it is nothing.
TEST(CorePin, IsAsThickAsTheHoleThatFacetsStandFor) {
  for (const int sides : {10, 12, 32}) {
    const Hole hole{.depth = 3.0, .radius = 0.5, .sides = sides};
    EXPECT_EQ(actions_text(plan_of(laid(block_with_hole(hole), 0.0)).plan), "1 slide") << sides;
  }
}

TEST(CorePin, ThatIsSlenderIsSaidToBend) {
  for (const double depth : {10.0, 15.0}) {
    const Planned planned = plan_of(laid(block_with_hole({.depth = depth, .radius = 0.75}), 0.0));
    ASSERT_EQ(actions_text(planned.plan), "1 slide");
    const std::optional<CorePin>& pin = planned.plan.actions[0].core_pin;
    ASSERT_TRUE(pin);
    EXPECT_NEAR(pin->width, 1.5, 0.03);
    EXPECT_NEAR(pin->length, depth, 0.3);
    const std::string notice = pins_notice(*planned.model, planned.plan);
    EXPECT_EQ(notice.empty(), depth < k_slender_pin * 1.5) << notice;
  }
}

TEST(CorePin, IsNoneOfASlotOrAPocket) {
  const Planned planned = plan_of(block_with_pockets(60.0));
  ASSERT_FALSE(planned.plan.actions.empty());
  for (const SideAction& action : planned.plan.actions)
    EXPECT_TRUE(!action.core_pin || action.core_pin->width > 1.0);
}

}  // namespace
}  // namespace moldlight
