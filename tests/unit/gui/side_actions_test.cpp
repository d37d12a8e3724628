// When side actions move while a mold opens, and where an arrow that is dragged across the direction points.
#include "gui/view/side_actions.hpp"

#include <random>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "mold/map_frame.hpp"

namespace moldlight::gui {
namespace {

SideAction action(ActionKind kind, double travel) {
  SideAction made;
  made.kind = kind;
  made.travel = travel;
  return made;
}

TEST(OpeningMold, MovesSlidesThenHalvesThenLifters) {
  ActionPlan plan;
  plan.actions = {action(ActionKind::slide, 12.0), action(ActionKind::lifter, 4.0),
                  action(ActionKind::unscrew, 9.0)};
  OpenedMold former;
  for (int k = 0; k <= 200; ++k) {
    const OpenedMold opened = opened_mold(&plan, k / 200.0);
    EXPECT_GE(opened.slides, former.slides);
    EXPECT_GE(opened.halves, former.halves);
    EXPECT_GE(opened.lifters, former.lifters);
    EXPECT_TRUE(opened.halves == 0.0 || opened.slides == 1.0) << k;
    EXPECT_TRUE(opened.lifters == 0.0 || opened.halves == 1.0) << k;
    former = opened;
  }
  EXPECT_EQ(former.slides, 1.0);
  EXPECT_EQ(former.halves, 1.0);
  EXPECT_EQ(former.lifters, 1.0);
  EXPECT_NEAR(opened_mold(&plan, 1.0 / 6.0).slides, 0.5, 1e-12) << "each has as much time";
}

TEST(OpeningMold, SaysInASentenceWhatMovesFirst) {
  ActionPlan plan;
  plan.actions = {action(ActionKind::slide, 12.0), action(ActionKind::lifter, 4.0)};
  EXPECT_EQ(first_moves_text(plan), "1 slide moves out first.");
  plan.actions.push_back(action(ActionKind::slide, 5.0));
  EXPECT_EQ(first_moves_text(plan), "2 slides move out first.");
  plan.actions.push_back(action(ActionKind::unscrew, 9.0));
  EXPECT_EQ(first_moves_text(plan), "2 slides and 1 unscrewing core move out first.");
}

TEST(OpeningMold, IsOfHalvesAloneWithoutActions) {
  const ActionPlan none;
  for (const double open : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(opened_mold(nullptr, open).halves, open, 1e-12);
    EXPECT_NEAR(opened_mold(&none, open).halves, open, 1e-12);
  }
  ActionPlan lifters;
  lifters.actions = {action(ActionKind::lifter, 50.0)};
  EXPECT_GT(opened_mold(&lifters, 0.01).halves, 0.0) << "nothing moves before";
  EXPECT_EQ(opened_mold(&lifters, 0.4).lifters, 0.0);
}

TEST(SideArrows, PointWhereTheHandIs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const glm::ivec2 size(1280, 720);
  for (int k = 0; k < 60; ++k) {
    Camera camera;
    camera.height = 0.4 + 0.3 * k / 60.0;
    camera.projection = k % 2 == 0 ? Projection::orthographic : Projection::perspective;
    const glm::dvec3 parting = glm::normalize(glm::dvec3(number(random), number(random), 1.5));
    const MapFrame frame = map_frame(parting);
    // Not along the plane, where two directions are seen as one.
    camera.orientation = looking_along(-(0.5 * frame.x + 0.8 * parting), parting);
    const double angle = 3.14 * number(random), before = angle + 0.6 * number(random);
    const auto level = [&](double a) { return std::cos(a) * frame.x + std::sin(a) * frame.y; };
    const glm::dvec3 tail(0.05 * number(random), 0.05 * number(random), 0.0);
    const auto seen = project(camera, size, tail + side_arrow_length(camera) * level(angle));
    ASSERT_TRUE(seen);
    const glm::dvec3 found =
        side_direction_at(camera, size, {tail, parting, level(before)}, glm::vec2(*seen));
    EXPECT_LT(glm::degrees(std::acos(std::min(glm::dot(found, level(angle)), 1.0))), 4.0) << k;
    EXPECT_NEAR(glm::dot(found, parting), 0.0, 1e-9);
  }
}

TEST(SideDirections, AreReplacedByThoseDraggedOn) {
  ActionSettings settings;
  give_side_direction(settings, glm::dvec3(1, 0, 0), {0, 1, 0});
  EXPECT_EQ(settings.side_directions.size(), 1U) << "an action's own is none of the user's";
  give_side_direction(settings, glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(1, 1, 0)));
  ASSERT_EQ(settings.side_directions.size(), 1U);
  EXPECT_GT(settings.side_directions[0].x, 0.7);
  give_side_direction(settings, std::nullopt, {1, 0, 0});
  EXPECT_EQ(settings.side_directions.size(), 2U);
  EXPECT_EQ(own_direction(settings, {1, 0, 0}), 1U);
  EXPECT_FALSE(own_direction(settings, {-1, 0, 0}));
}

}  // namespace
}  // namespace moldlight::gui
