// Undercuts that are pinned to a kind of action, and directions of the user's own.
#include "actions/pins.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "actions/side_action.hpp"
#include "base/error.hpp"
#include "support/mesh_edits.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::box_face;
using test::SolidBuilder;

/// A block with a pocket in its +x side, 10 deep, and one in its -x side, 15 deep.
TriangleMesh block_with_two_pockets() {
  const glm::dvec3 low(-40, 0, 0), high(40, 30, 20);
  const glm::dvec3 a_low(30, 10, 5), a_high(40, 20, 15), b_low(-40, 10, 5), b_high(-25, 20, 15);
  SolidBuilder solid;
  solid.box(low, high, {0, 1});
  solid.box(a_low, a_high, {1}, true);
  solid.box(b_low, b_high, {0}, true);
  solid.face(box_face(low, high, 1), {box_face(a_low, a_high, 1)});
  solid.face(box_face(low, high, 0), {box_face(b_low, b_high, 0)});
  return solid.mesh();
}

ActionPlan pinned_plan(const ActionSettings& settings, const glm::dvec3& direction = {0, 0, 1}) {
  Part part;
  part.unit = "mm";
  part.mesh = block_with_two_pockets();
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  const auto model = prepare_part(std::move(part), Progress());
  Query query;
  query.direction = direction;
  const Classification result = classify_exact(*model, query, Progress(), true);
  return find_actions(*model, result, settings, Progress());
}

ActionPin pin_to(const UndercutReport& noted, std::optional<ActionKind> kind) {
  return {.point = noted.point, .area = noted.undercut.area, .kind = kind};
}

class Pins : public ::testing::Test {
 protected:
  const ActionPlan free = pinned_plan({});
  ActionSettings settings;
};

TEST_F(Pins, PutAPointOnEachUndercut) {
  ASSERT_EQ(free.undercuts.size(), 2U);
  EXPECT_EQ(actions_text(free), "2 slides");
  EXPECT_GT(free.undercuts[1].point.x, 30.0 - 1e-4) << "the smaller one";
  EXPECT_LT(free.undercuts[0].point.x, -25.0 + 1e-4);
  EXPECT_FALSE(free.undercuts[0].pin);
}

TEST_F(Pins, LeaveAnUndercutToTheirKindAlone) {
  settings.pins = {pin_to(free.undercuts[0], ActionKind::strip)};
  const ActionPlan plan = pinned_plan(settings);
  EXPECT_EQ(actions_text(plan), "1 slide") << "a pocket is no ring";
  ASSERT_EQ(plan.unreleased, std::vector<std::size_t>{0});
  EXPECT_EQ(unreleased_text(plan, 0), "no stripped ring releases it");
  EXPECT_EQ(plan.undercuts[0].pin, settings.pins[0]);
  EXPECT_EQ(action_of(plan, 0), nullptr);
  EXPECT_EQ(action_of(plan, 1)->kind, ActionKind::slide);

  settings.pins = {pin_to(free.undercuts[0], ActionKind::slide), pin_to(free.undercuts[1], std::nullopt)};
  const ActionPlan other = pinned_plan(settings);
  ASSERT_EQ(other.unreleased, std::vector<std::size_t>{1});
  EXPECT_EQ(unreleased_text(other, 1), "left as it is");
  EXPECT_EQ(other.actions.at(0).kind, ActionKind::slide);
  EXPECT_NEAR(other.actions.at(0).travel, free.actions.at(0).travel, 1e-9) << "as without the pin";
}

TEST_F(Pins, FindAKindThatWouldCostMore) {
  settings.pins = {pin_to(free.undercuts[0], ActionKind::lifter)};
  const ActionPlan plan = pinned_plan(settings);
  EXPECT_EQ(actions_text(plan), "1 slide, 1 lifter");
  EXPECT_EQ(action_of(plan, 0)->kind, ActionKind::lifter);
  EXPECT_NEAR(action_of(plan, 0)->travel, 15.0, 0.1) << "out of the pocket";
}

TEST_F(Pins, LeaveWhatNoActionOfTheirKindReleases) {
  settings.pins = {pin_to(free.undercuts[0], ActionKind::inclined),
                   pin_to(free.undercuts[1], ActionKind::strip)};
  const ActionPlan plan = pinned_plan(settings);
  EXPECT_TRUE(plan.actions.empty());
  EXPECT_EQ(plan.unreleased.size(), 2U);
  EXPECT_EQ(unreleased_text(plan, 1), "no stripped ring releases it");
}

TEST_F(Pins, AreFoundAgainByPlaceAndArea) {
  settings.pins = {pin_to(free.undercuts[0], std::nullopt)};
  const double turn = glm::radians(3.0);
  const ActionPlan turned = pinned_plan(settings, {0, std::sin(turn), std::cos(turn)});
  const auto pinned = std::ranges::count_if(
      turned.undercuts, [](const UndercutReport& noted) { return noted.pin.has_value(); });
  EXPECT_EQ(pinned, 1) << "for another direction, too";
  settings.pins[0].area *= 2.5;
  EXPECT_TRUE(pinned_plan(settings).unreleased.empty()) << "another undercut";
  settings.pins[0] = pin_to(free.undercuts[0], std::nullopt);
  settings.pins[0].point += glm::dvec3(0, 0, 15);
  EXPECT_TRUE(pinned_plan(settings).unreleased.empty()) << "elsewhere";
}

TEST_F(Pins, OfOneUndercutTheLastOneCounts) {
  settings.pins = {pin_to(free.undercuts[0], std::nullopt), pin_to(free.undercuts[0], ActionKind::slide)};
  EXPECT_TRUE(pinned_plan(settings).unreleased.empty());
}

TEST_F(Pins, ReadBackWhatTheyWrite) {
  settings.pins = {pin_to(free.undercuts[0], std::nullopt), pin_to(free.undercuts[1], ActionKind::lifter)};
  EXPECT_EQ(parse_pins(pins_text(settings.pins)), settings.pins);
  EXPECT_TRUE(parse_pins("").empty());
  for (const char* bad : {"1,2,3,4", "1,2,3,4,car", "1,2,3,0,slide", "1,2,x,4,slide", "1,2,3,4,slide;;", ";"})
    EXPECT_THROW(static_cast<void>(parse_pins(bad)), UsageError) << bad;
}

TEST(SideDirections, OfTheUsersOwnAreTakenAsTheyAre) {
  // A groove along y, open at both ends: its own axes are tried, and both senses are as short.
  SolidBuilder solid;
  solid.extrude({{0, 0}, {20, 0}, {20, 5}, {10, 5}, {10, 10}, {20, 10}, {20, 15}, {0, 15}}, {}, 60.0);
  Part part;
  part.unit = "mm";
  part.mesh = solid.mesh();
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  const auto model = prepare_part(std::move(part), Progress());
  const Classification result = classify_exact(*model, Query(), Progress(), true);
  const auto direction_with = [&](const ActionSettings& settings) {
    return find_actions(*model, result, settings, Progress()).actions.at(0).direction;
  };
  EXPECT_GT(direction_with({}).x, 1.0 - 1e-6);
  const double turn = glm::radians(40.0);
  const glm::dvec3 wish(std::cos(turn), std::sin(turn), 0.0);
  ActionSettings settings;
  settings.side_directions = {wish};
  EXPECT_GT(glm::dot(direction_with(settings), wish), 1.0 - 1e-9) << "free, though far from the middle";
  settings.side_directions = {-wish};
  EXPECT_GT(direction_with(settings).x, 1.0 - 1e-6) << "one that is not free is nothing";
}

}  // namespace
}  // namespace moldlight
