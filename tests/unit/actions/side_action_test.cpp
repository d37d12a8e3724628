// Side actions of parts whose release is known in closed form.
#include "actions/side_action.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "actions/actions_report.hpp"
#include "mold/direction.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

using test::Loop2;
using test::SolidBuilder;

TEST(SideHole, AtAnyAzimuthIsASlideAlongItsAxis) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> azimuths(0.0, 360.0);
  for (int k = 0; k < 40; ++k) {
    const double azimuth = azimuths(random);
    Hole hole{.draft_deg = k % 4 < 2 ? 0.0 : 0.5 + 0.1 * k, .through = k % 2 == 1};
    hole.draft_deg = std::min(hole.draft_deg, 4.0);
    hole.turn_deg = azimuth;
    const Planned planned = plan_of(laid(block_with_hole(hole), azimuth));
    ASSERT_EQ(planned.plan.actions.size(), 1U) << azimuth << " " << hole.draft_deg;
    const SideAction& action = planned.plan.actions.front();
    EXPECT_EQ(action.kind, ActionKind::slide);
    EXPECT_TRUE(planned.plan.unreleased.empty());
    const glm::dvec3 axis(std::cos(glm::radians(azimuth)), std::sin(glm::radians(azimuth)), 0.0);
    const double off_deg = line_angle_deg(action.direction, axis);
    EXPECT_LT(off_deg, 0.01) << azimuth << " " << hole.draft_deg;
    if (!hole.through || hole.draft_deg > k_tau_deg) {
      EXPECT_GT(glm::dot(action.direction, axis), 0.0) << "out of the open, or the wide, end";
    }
    // Walls of a polygon turn a little farther than those of a circle.
    const double free_deg = hole.draft_deg + k_tau_deg;
    EXPECT_NEAR(action.interval.to_deg, free_deg, 0.05) << azimuth << " " << hole.draft_deg;
    EXPECT_NEAR(action.interval.from_deg, -free_deg, 0.05) << azimuth << " " << hole.draft_deg;
    const double depth = hole.through ? 22.0 : hole.depth;
    EXPECT_NEAR(action.travel, depth + 3.0, 1e-3 * planned.model->frame.diagonal)
        << azimuth << " " << hole.draft_deg;
  }
}

TEST(SideHole, InOneDirectionOnlyIfBlind) {
  const Planned planned = plan_of(laid(block_with_hole({}), 0.0), {}, {0, 0, -1});
  ASSERT_EQ(planned.plan.actions.size(), 1U) << "d reversed";
  EXPECT_GT(planned.plan.actions[0].direction.x, 1.0 - 1e-9);
  EXPECT_EQ(planned.plan.undercuts.size(), 1U);
  EXPECT_EQ(released_by_text(planned.plan, 0), "slide 1");
  EXPECT_FALSE(planned.plan.undercuts[0].blocked_by.empty());
  EXPECT_NEAR(planned.plan.undercuts[0].depth.value(), 14.0, 0.02);
  EXPECT_NEAR(planned.plan.undercuts[0].formed_area, planned.plan.undercuts[0].undercut.area, 1e-6);
}

TEST(SideHole, HardlyOffAnAxisIsASlideAlongTheAxis) {
  const Planned near = plan_of(laid(block_with_hole({}), 0.06)),
                off = plan_of(laid(block_with_hole({}), 0.3));
  ASSERT_EQ(near.plan.actions.size(), 1U);
  EXPECT_EQ(glm::abs(near.plan.actions[0].direction), glm::dvec3(1, 0, 0));
  EXPECT_NEAR(near.plan.actions[0].interval.to_deg + near.plan.actions[0].interval.from_deg, 0.12, 0.02);
  ASSERT_EQ(off.plan.actions.size(), 1U);
  EXPECT_NEAR(line_angle_deg(off.plan.actions[0].direction, {1, 0, 0}), 0.3, 0.01);
}

TEST(SideHole, StraightIsASlideWithoutAnyTolerance) {
  Part part;
  part.mesh = laid(block_with_hole({}), 30.0);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  const auto model = prepare_part(std::move(part), Progress());
  Query query;
  query.method.tau_deg = 0.0;
  const Classification result = classify_exact(*model, query, Progress(), true);
  const ActionPlan plan = find_actions(*model, result, {}, Progress());
  EXPECT_EQ(actions_text(plan), "1 slide");
  EXPECT_TRUE(plan.unreleased.empty());
}

/// Before any body is made the plan has what it comes to all the same.
TEST(SideHole, SearchEndsOnceMoreIsLeftThanIsWanted) {
  const Planned planned = plan_of(laid(block_with_hole({}), 0.0));
  const ActionPlan plan =
      find_actions(*planned.model, planned.result, {}, Progress(), PlanDetail::whole, -1.0);
  ASSERT_EQ(plan.undercuts.size(), planned.plan.undercuts.size());
  EXPECT_EQ(plan.undercuts[0].undercut.area, planned.plan.undercuts[0].undercut.area);
  ASSERT_EQ(plan.actions.size(), 1U);
  EXPECT_FALSE(plan.actions[0].body.has_value());
}

/// Within 5 degrees of the plane it is a slide, up to 30 an inclined one, beyond a loose insert.
TEST(SideHole, LeaningOutOfThePlaneIsInclined) {
  for (const auto& [lean_deg, kind] :
       {std::pair(3.0, ActionKind::slide), std::pair(20.0, ActionKind::inclined),
        std::pair(45.0, ActionKind::insert)}) {
    const glm::dquat lean = glm::angleAxis(glm::radians(-lean_deg), glm::dvec3(0, 1, 0));
    const Planned planned = plan_of(test::rotated(laid(block_with_hole({}), 0.0), lean));
    const auto& actions = planned.plan.actions;
    const auto found = std::ranges::find_if(actions, [&](const SideAction& action) {
      return line_angle_deg(action.direction, lean * glm::dvec3(1, 0, 0)) < 0.01;
    });
    ASSERT_NE(found, actions.end()) << lean_deg;
    EXPECT_EQ(found->kind, kind) << lean_deg;
    const auto& rejected = planned.plan.rejected;
    ASSERT_EQ(rejected.empty(), lean_deg < 30.0) << lean_deg;
    if (rejected.empty()) continue;
    EXPECT_EQ(rejected[0].reason, RejectReason::too_steep);
    EXPECT_NEAR(rejected[0].lean_deg, lean_deg, 0.01);
    EXPECT_NEAR(line_angle_deg(rejected[0].direction, lean * glm::dvec3(1, 0, 0)), 0.0, 0.01);
    EXPECT_NE(rejected_text(*planned.model, planned.plan).find("(it leans 45.0° off"), std::string::npos);
  }
}

/// A slot in a side, whose floor leans out under the part's top: the lower part of the floor is the core's,
/// but the slide that forms the rest forms it, too; not a floor of which it is a small part.
TEST(SideAction, FormsTheFacesOfItsUndercutThatAreHardlyMore) {
  for (const double end : {30.0, 200.0}) {
    SolidBuilder solid;  // in the xz-plane: the notch's back runs from (10, 4) to (16, 16), over it a lid
    solid.extrude({{0, 0}, {end, 0}, {end, 4}, {10, 4}, {16, 16}, {22, 16}, {22, 20}, {0, 20}}, {}, 12.0);
    const Planned planned = plan_of(solid.mesh(), {}, {0, 0, 1});
    SCOPED_TRACE(end);
    ASSERT_EQ(planned.plan.undercuts.size(), 1U);
    const UndercutReport& noted = planned.plan.undercuts.front();
    const double back_and_lid = 12.0 * (std::sqrt(180.0) + 6.0), hidden = 12.0 * 12.0;
    EXPECT_NEAR(noted.undercut.area, back_and_lid + hidden, 0.1) << "with the floor from x = 10 to 22";
    const double floor = end == 30.0 ? 12.0 * (end - 10.0) : hidden;
    EXPECT_NEAR(noted.formed_area, back_and_lid + floor, 0.1);
  }
}

/// A notch under a roof that reaches far beyond it: a slide need not pass the roof if it belongs to the other
/// half.
TEST(SideAction, BelongsToTheHalfThatItMustTravelLessFor) {
  SolidBuilder solid;
  solid.extrude(
      {{0, 0}, {20, 0}, {20, 5}, {10, 5}, {10, 10}, {20, 10}, {20, 15}, {40, 15}, {40, 20}, {0, 20}}, {},
      60.0);
  const Planned planned = plan_of(solid.mesh());
  ASSERT_EQ(planned.plan.actions.size(), 1U);
  const SideAction& action = planned.plan.actions.front();
  EXPECT_GT(action.direction.x, 1.0 - 1e-6);
  EXPECT_NEAR(action.travel, 10.0 + 3.0, 1e-3 * planned.model->frame.diagonal) << "not 30, as from above";
  EXPECT_FALSE(action.core_side);
  const Planned turned = plan_of(solid.mesh(), {}, {0, 0, -1});
  ASSERT_EQ(turned.plan.actions.size(), 1U);
  EXPECT_TRUE(turned.plan.actions.front().core_side) << "d reversed swaps the sides";
}

TEST(SideAction, OfAPartWithoutUndercutsIsNone) {
  SolidBuilder solid;
  solid.box({0, 0, 0}, {10, 10, 10});
  const Planned planned = plan_of(solid.mesh());
  EXPECT_TRUE(planned.plan.actions.empty());
  EXPECT_TRUE(planned.plan.undercuts.empty());
  EXPECT_TRUE(planned.plan.optimal);
  EXPECT_EQ(actions_text(planned.plan), "none");
}

TEST(SideAction, OfAClosedVoidIsNone) {
  SolidBuilder solid;
  solid.box({0, 0, 0}, {10, 10, 10});
  solid.box({3, 3, 3}, {7, 7, 7}, {}, true);
  const Planned planned = plan_of(solid.mesh());
  EXPECT_EQ(actions_text(planned.plan), "none");
  EXPECT_NEAR(planned.plan.unreleased_area, 6.0 * 16.0, 1e-9);
}

/// What lies inside another body is released by nothing, however free the ways are that begin there.
TEST(SideAction, OfWhatAnotherBodyCoversIsNone) {
  SolidBuilder solid;
  solid.extrude({{0, 0}, {20, 0}, {20, 5}, {10, 5}, {10, 10}, {20, 10}, {20, 15}, {0, 15}}, {}, 30.0);
  const Planned bare = plan_of(solid.mesh());
  ASSERT_EQ(actions_text(bare.plan), "1 slide");
  // A bar within the upper limb, through its ceiling of the groove into the lower one.
  solid.box({12, 10, -2}, {16, 20, 12});
  const Planned crossed = plan_of(solid.mesh());
  EXPECT_GT(crossed.plan.unreleased_area, 3.9 * 9.9) << "where the bar stands on the groove's walls";
}

/// A hook sticks out of the wall at x = 2 over the whole width: a lifter moves out from under it by the
/// hook's length.
TEST(SideAction, UnderAHookInABoxIsALifter) {
  constexpr double k_hook = 3.0;
  const TriangleMesh mesh = block_with_cavity(
      {{2, 20}, {2, 16}, {2 + k_hook, 16}, {2 + k_hook, 14}, {2, 14}, {2, 2}, {38, 2}, {38, 20}}, {40, 20},
      30.0);
  for (const double sense : {1.0, -1.0}) {
    ActionSettings settings;
    settings.lifter_angle_deg = 10.0;
    const Planned planned = plan_of(mesh, settings, {0, 0, sense});
    ASSERT_EQ(planned.plan.actions.size(), 1U);
    const SideAction& action = planned.plan.actions.front();
    ASSERT_EQ(action.kind, ActionKind::lifter);
    EXPECT_GT(action.direction.x, 1.0 - 1e-6);
    EXPECT_NEAR(action.travel, k_hook, 1e-3 * planned.model->frame.diagonal);
    EXPECT_NEAR(*action.stroke, action.travel / std::tan(glm::radians(10.0)), 1e-9);
    EXPECT_EQ(action.core_side, sense > 0.0) << "the box is open above";
    EXPECT_NEAR(action.clear_to, 33.0, 0.2) << "from below the hook's tip to the wall across";
    EXPECT_TRUE(planned.plan.unreleased.empty());
  }
}

/// A sill on the floor keeps what lies behind it from following: a lifter that forms the rest is no use, but
/// where the user asks for one.
TEST(SideAction, ThatLeavesTheRestOfItsUndercutIsRefused) {
  const TriangleMesh mesh = block_with_cavity({{2, 20},
                                               {2, 16},
                                               {5, 16},
                                               {5, 14},
                                               {2, 14},
                                               {2, 2},
                                               {4, 2},
                                               {4, 3},
                                               {4.5, 3},
                                               {4.5, 2},
                                               {38, 2},
                                               {38, 20}},
                                              {40, 20}, 30.0);
  // Behind the sill: the floor, the wall up to its height, and the sill's back.
  constexpr double k_rest = 30.0 * (2.0 + 1.0 + 1.0);
  const Planned planned = plan_of(mesh);
  EXPECT_EQ(actions_text(planned.plan), "none");
  const UndercutReport& found = planned.plan.undercuts.at(0);
  EXPECT_NEAR(planned.plan.unreleased_area, found.undercut.area, 10.0) << "but for what is shallow";
  const auto refused = std::ranges::find(planned.plan.rejected, ActionKind::lifter, &RejectedAction::kind);
  ASSERT_NE(refused, planned.plan.rejected.end());
  EXPECT_EQ(refused->reason, RejectReason::leaves_rest);
  EXPECT_NEAR(refused->travel, 3.0, 0.1);
  EXPECT_GT(refused->direction.x, 1.0 - 1e-6);
  EXPECT_NE(rejected_text(*planned.model, planned.plan).find("lifter for undercut 1 (it leaves "),
            std::string::npos);

  ActionSettings asked;
  asked.pins = {{.point = found.point, .area = found.undercut.area, .kind = ActionKind::lifter}};
  const Planned wished = plan_of(mesh, asked);
  ASSERT_EQ(actions_text(wished.plan), "1 lifter");
  EXPECT_NEAR(wished.plan.actions[0].travel, 3.0, 0.1);
  EXPECT_NEAR(wished.plan.unreleased_area, k_rest, 10.0);
  EXPECT_EQ(released_by_text(planned.plan, 0), "no action tried releases it");
  EXPECT_EQ(released_by_text(wished.plan, 0), "lifter 1, in part");
}

/// A hook over the whole width may turn by no more than the draft of the ends; one that stands alone until
/// the way out from under it is a tenth longer.
TEST(SideAction, ThatIsALifterTellsHowFarItMayTurn) {
  constexpr double k_hook = 3.0;
  const Loop2 profile = {{2, 20}, {2, 16}, {2 + k_hook, 16}, {2 + k_hook, 14},
                         {2, 14}, {2, 2},  {38, 2},          {38, 20}};
  const Planned wide = plan_of(block_with_cavity(profile, {40, 20}, 30.0));
  ASSERT_EQ(actions_text(wide.plan), "1 lifter");
  EXPECT_NEAR(wide.plan.actions[0].interval.from_deg, -k_tau_deg, 0.05);
  EXPECT_NEAR(wide.plan.actions[0].interval.to_deg, k_tau_deg, 0.05);
  // Through a window under it a lifter rises with the part; walls of the window bound nothing.
  const Planned alone = plan_of(box_with_hook(k_hook));
  ASSERT_EQ(actions_text(alone.plan), "1 lifter");
  const SideAction& lifter = alone.plan.actions[0];
  EXPECT_NEAR(lifter.travel, k_hook, 0.01);
  const double tenth_deg = glm::degrees(std::acos(1.0 / 1.1));
  EXPECT_NEAR(lifter.interval.to_deg, tenth_deg, 0.1);
  EXPECT_NEAR(lifter.interval.from_deg, -tenth_deg, 0.1);
}

/// Out from under the hook is the shortest way, but only if there is room for the lifter's own thickness
/// before the wall across. A slanted way has more; to a side is farther; where there is no room there either
/// it is reported.
TEST(SideAction, ThatIsALifterHasRoomBeyondItsTravel) {
  constexpr double k_hook = 3.0, k_room = 3.0;
  struct Case {
    double ahead, beside;
    double slant_deg;  // of the shortest way with room, at least
    bool has_room;
  };
  const double slant_deg = glm::degrees(std::acos(2.5 / k_room));
  for (const auto& [ahead, beside, least_deg, has_room] :
       {Case{k_hook + 20.0, 20.0, 0.0, true}, Case{k_hook + k_room + 0.5, 20.0, 0.0, true},
        Case{k_hook + k_room - 0.5, 20.0, slant_deg, true},
        Case{k_hook + 0.5, k_hook_width + k_room + 0.5, 90.0, true},
        Case{k_hook + 0.5, k_room - 0.5, 0.0, false}}) {
    SCOPED_TRACE(::testing::Message() << ahead << " ahead, " << beside << " beside");
    const Planned planned = plan_of(box_with_hook(k_hook, ahead, beside), without_stems());
    EXPECT_EQ(rejected_text(*planned.model, planned.plan).empty(), has_room);
    ASSERT_EQ(planned.plan.rejected.empty(), has_room);
    if (!has_room) {
      const RejectedAction& rejected = planned.plan.rejected[0];
      EXPECT_TRUE(rejected_text(*planned.model, planned.plan)
                      .starts_with("Refused: lifter for undercut 1 (it travels 3 mm and has "))
          << rejected_text(*planned.model, planned.plan);
      EXPECT_EQ(actions_text(planned.plan), "none") << "what cannot be built is no action";
      EXPECT_GT(planned.plan.unreleased_area, 0.9 * planned.plan.undercuts[0].undercut.area);
      EXPECT_EQ(rejected.kind, ActionKind::lifter);
      EXPECT_EQ(rejected.reason, RejectReason::no_room);
      EXPECT_NEAR(rejected.direction.x, 1.0, 1e-9);
      EXPECT_NEAR(rejected.travel, k_hook, 0.01);
      EXPECT_NEAR(rejected.room, ahead - k_hook, 0.3);
      EXPECT_NEAR(rejected.place.x, 2.0 + k_hook, 0.3) << "under the hook's edge";
      const ActionSettings settings = without_stems();
      const ActionsReport report{*planned.model, planned.result, settings, planned.plan};
      EXPECT_EQ(actions_json(report)["rejected"][0]["undercut"], 1);
      continue;
    }
    ASSERT_EQ(actions_text(planned.plan), "1 lifter");
    const SideAction& lifter = planned.plan.actions[0];
    const double its_deg = glm::degrees(std::atan2(std::abs(lifter.direction.y), lifter.direction.x));
    EXPECT_GT(its_deg, least_deg - 0.01);
    EXPECT_LT(its_deg, least_deg + (least_deg > 0.0 && least_deg < 90.0 ? 5.0 : 0.01)) << "one of a fan";
    const double cosine = least_deg < 90.0 ? lifter.direction.x : 1.0;
    EXPECT_NEAR(lifter.travel, (least_deg < 90.0 ? k_hook : k_hook_width) / cosine, 0.01);
    EXPECT_NEAR(lifter.clear_to, (least_deg < 90.0 ? ahead : beside) / cosine, 0.3) << "from the hook's edge";
    EXPECT_EQ(lifter.room_needed, k_room);
    EXPECT_TRUE(moldlight::has_room(lifter));
  }
  ActionSettings thin = without_stems();
  thin.lifter_room_mm = 0.2;
  const Planned planned = plan_of(box_with_hook(k_hook, k_hook + 0.5, 20.0), thin);
  ASSERT_EQ(actions_text(planned.plan), "1 lifter");
  EXPECT_NEAR(planned.plan.actions[0].travel, k_hook, 0.01) << "a lifter as thin as asked for fits";
}

/// The slot's two undercut wings lie across from each other: each is a lifter that moves in by its overhang,
/// or where the slot's ends are open both are one slide along it.
TEST(SideAction, InATSlotIsALifterForEachWing) {
  constexpr double k_overhang = 4.0;
  const Loop2 profile = {{16, 20},
                         {16, 12},
                         {16 - k_overhang, 12},
                         {16 - k_overhang, 6},
                         {24 + k_overhang, 6},
                         {24 + k_overhang, 12},
                         {24, 12},
                         {24, 20}};
  const Planned planned = plan_of(block_with_cavity(profile, {40, 20}, 30.0), without_stems());
  EXPECT_EQ(planned.plan.actions.size(), 2U);
  for (const SideAction& action : planned.plan.actions) {
    EXPECT_EQ(action.kind, ActionKind::lifter);
    EXPECT_NEAR(std::abs(action.direction.x), 1.0, 1e-6);
    EXPECT_NEAR(action.travel, k_overhang, 0.05);
  }
}

/// Hooks side by side are one lifter's, however many there are; not where the gap is wider than they are.
TEST(SideAction, OfHooksSideBySideIsOneLifter) {
  const auto of = [](const std::vector<double>& starts) {
    return plan_of(box_with_hooks(3.0, 33.0, 70.0, starts));
  };
  const Planned near = of({12.0, 20.0, 28.0});
  ASSERT_EQ(near.plan.undercuts.size(), 3U);
  ASSERT_EQ(actions_text(near.plan), "1 lifter");
  const SideAction& lifter = near.plan.actions[0];
  EXPECT_EQ(lifter.undercuts.size(), 3U);
  EXPECT_EQ(lifter.feature, "3 hooks");
  EXPECT_NEAR(lifter.travel, 3.0, 0.01);
  EXPECT_GT(lifter.direction.x, 1.0 - 1e-6);
  EXPECT_FALSE(lifter.body->hit.has_value());
  EXPECT_EQ(actions_text(of({12.0, 34.0}).plan), "2 lifters");
}

/// A notch that opens to two sides goes with the slide of either.
TEST(SideAction, IsSharedWithWhatMayTurnToIt) {
  for (const bool pocket_at_x : {true, false}) {
    const Planned planned = plan_of(block_with_corner_notch(pocket_at_x));
    ASSERT_EQ(planned.plan.undercuts.size(), 2U);
    ASSERT_EQ(actions_text(planned.plan), "1 slide") << pocket_at_x;
    const glm::dvec3& way = planned.plan.actions[0].direction;
    EXPECT_NEAR(pocket_at_x ? way.x : -way.y, 1.0, 1e-9);
  }
}

/// In the middle of what is free a wall of the part faces; most of its walls face the axes at the ends.
TEST(SideAction, GoesAlongAnAxisRatherThanWhereFewWallsFace) {
  const Planned planned = plan_of(chamfered_block_with_notch());
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  const SideAction& slide = planned.plan.actions[0];
  EXPECT_NEAR(std::max(slide.direction.x, -slide.direction.y), 1.0, 1e-9);
  EXPECT_NEAR(slide.interval.to_deg - slide.interval.from_deg, 90.0 + 2.0 * k_tau_deg, 0.1);
}

TEST(SideAction, IsSharedByPocketsThatAreNearEachOther) {
  for (const auto& [apart, number] : {std::pair(40.0, 1U), std::pair(60.0, 2U)}) {
    const Planned planned = plan_of(block_with_pockets(apart));
    EXPECT_EQ(planned.plan.actions.size(), number) << apart;
    EXPECT_EQ(planned.plan.undercuts.size(), 2U);
    ActionSettings settings;
    settings.bundle_across_mm = 70.0;
    EXPECT_EQ(plan_of(block_with_pockets(apart), settings).plan.actions.size(), 1U) << apart;
    settings.bundle_across_mm = 10.0;
    EXPECT_EQ(plan_of(block_with_pockets(apart), settings).plan.actions.size(), 2U) << apart;
  }
}

}  // namespace
}  // namespace moldlight
