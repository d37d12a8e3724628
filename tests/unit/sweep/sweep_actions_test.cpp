// Sweeps of a block whose directions tie in undercut area, but not in what releases it.
#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"
#include "sweep/direction_actions.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight {
namespace {

using test::box_face;
using test::Loop;
using test::SolidBuilder;

constexpr double k_half = 4.0, k_depth = 10.0;

struct Pocket {
  int face;           // of the block: 0 … 5 as -x, +x, …
  glm::dvec3 middle;  // of its opening
  double depth = k_depth;
};

glm::dvec3 outward(int face) {
  glm::dvec3 normal(0.0);
  normal[face / 2] = face % 2 == 0 ? -1.0 : 1.0;
  return normal;
}

/// A square around the middle, counter-clockwise seen from outside.
Loop opening(const Pocket& pocket) {
  const glm::dvec3 normal = outward(pocket.face);
  glm::dvec3 u(0.0);
  u[(pocket.face / 2 + 1) % 3] = k_half;
  const glm::dvec3 v = glm::cross(normal, u);
  return {pocket.middle - u - v, pocket.middle + u - v, pocket.middle + u + v, pocket.middle - u + v};
}

TriangleMesh block_with(const glm::dvec3& size, const std::vector<Pocket>& pockets) {
  SolidBuilder solid;
  std::vector<int> pierced;
  for (const Pocket& pocket : pockets) pierced.push_back(pocket.face);
  solid.box({0, 0, 0}, size, pierced);
  for (int face = 0; face < 6; ++face) {
    std::vector<Loop> rims;
    for (const Pocket& pocket : pockets) {
      if (pocket.face != face) continue;
      const Loop rim = opening(pocket);
      Loop floor = rim;
      for (glm::dvec3& corner : floor) corner -= pocket.depth * outward(face);
      solid.walls({floor.rbegin(), floor.rend()}, {rim.rbegin(), rim.rend()});
      solid.face(floor);
      rims.push_back(rim);
    }
    if (!rims.empty()) solid.face(box_face({0, 0, 0}, size, face), rims);
  }
  return solid.mesh();
}

/// Two pockets beside each other in +x, two opposite ones in +z and -z, one in +y. Along z one slide releases
/// the two of x, along x each of those of z wants its own; the area is the same.
TriangleMesh block(double depth_in_x = k_depth) {
  return block_with({36, 50, 40}, {{1, {36, 12, 20}, depth_in_x},
                                   {1, {36, 24, 20}, depth_in_x},
                                   {5, {10, 18, 40}},
                                   {4, {10, 18, 0}},
                                   {3, {18, 50, 20}}});
}

SweepSettings of_axes() {
  SweepSettings settings;
  settings.kinds = {CandidateKind::axis};
  settings.refine = 0;
  settings.rank = SweepRank::objective;
  settings.top = 3;
  return settings;
}

SweepResult sweep_of(const TriangleMesh& mesh, const SweepSettings& settings) {
  return run_sweep(test::model_of(mesh), settings, Progress(), {});
}

std::string axes(const SweepResult& result) {
  std::string names;
  for (const SweepCandidate& candidate : result.candidates) {
    const glm::dvec3 along = glm::abs(candidate.candidate.direction);
    names += along.x > 0.9 ? 'x' : along.y > 0.9 ? 'y' : 'z';
  }
  return names;
}

TEST(SweepActions, DecideTies) {
  SweepSettings settings = of_axes();
  const SweepResult plain = sweep_of(block(), settings);
  ASSERT_EQ(axes(plain), "xzy") << "x has the smaller draw depth";
  EXPECT_EQ(plain.candidates[1].tie_group, 1U);
  EXPECT_FALSE(plain.candidates[0].actions);
  EXPECT_EQ(plain.with_actions, 0U);

  settings.actions = true;
  const SweepResult result = sweep_of(block(), settings);
  ASSERT_EQ(axes(result), "zxy");
  EXPECT_EQ(result.with_actions, 3U);
  EXPECT_EQ(result.candidates[1].tie_group, 1U);
  EXPECT_EQ(result.candidates[0].actions->text(), "2 slides");
  EXPECT_EQ(result.candidates[1].actions->text(), "3 slides");
  EXPECT_EQ(figure_value(direction_figure("side_actions"), result.candidates[0]), 2.0);
  EXPECT_EQ(figure_value(direction_figure("unreleased_area"), result.candidates[0]), 0.0);
  EXPECT_NEAR(*figure_value(direction_figure("travel"), result.candidates[0]), k_depth + 3.0, 0.1);
  // But for the order of ties it is the same list.
  EXPECT_EQ(undercut_area(plain.candidates[0]), undercut_area(result.candidates[1]));
  EXPECT_EQ(undercut_area(plain.candidates[2]), undercut_area(result.candidates[2]));
}

TEST(SweepActions, AreAnObjective) {
  SweepSettings settings = of_axes();
  ASSERT_EQ(axes(sweep_of(block(14.0), settings)), "xzy") << "the pockets in x are hidden from z";
  settings.objective = parse_objective("side-actions");
  const SweepResult result = sweep_of(block(14.0), settings);
  EXPECT_EQ(axes(result).front(), 'z');
  EXPECT_EQ(result.candidates[0].actions->text(), "2 slides");
  EXPECT_EQ(result.candidates[0].tie_group, 1U);
  EXPECT_EQ(result.candidates[1].tie_group, 2U);
  EXPECT_GT(undercut_area(result.candidates[0]), undercut_area(result.candidates[1]));
  settings.objective = parse_objective("travel");
  EXPECT_EQ(axes(sweep_of(block(14.0), settings)).front(), 'x') << "the deep pockets are the mold's";
}

/// Of twice as many directions as are listed.
TEST(SweepActions, AreFoundForABoundedNumber) {
  SweepSettings settings = of_axes();
  settings.top = 1;
  settings.objective = parse_objective("side-actions");
  const SweepResult result = sweep_of(block(14.0), settings);
  EXPECT_EQ(result.with_actions, 2U);
  ASSERT_EQ(result.candidates.size(), 1U);
  EXPECT_EQ(axes(result), "z");
  settings.user_directions = {{0, 1, 0}};
  const SweepResult given = sweep_of(block(14.0), settings);
  EXPECT_EQ(given.with_actions, 3U) << "y is the last by undercut, but the user's";
  EXPECT_EQ(axes(given), "zy");
}

TEST(SweepActions, FollowTheSettings) {
  SweepSettings settings = of_axes();
  settings.actions = true;
  settings.action_settings.bundle_across_mm = 0.0;
  EXPECT_EQ(sweep_of(block(), settings).candidates[0].actions->text(), "3 slides");
  settings.action_settings.clearance_mm = 20.0;
  EXPECT_NEAR(sweep_of(block(), settings).candidates[0].actions->travel, k_depth + 20.0, 0.1);
}

TEST(SweepActions, OfATurnedPartAreTheSame) {
  SweepSettings settings = of_axes();
  settings.kinds = {CandidateKind::plane};
  settings.objective = parse_objective("side-actions");
  for (const std::uint32_t seed : {2U, 9U}) {
    const glm::dquat rotation = test::random_rotation(seed);
    const SweepResult result = sweep_of(test::rotated(block(14.0), rotation), settings);
    const SweepCandidate& best = result.candidates.front();
    EXPECT_LT(line_angle_deg(best.candidate.direction, rotation * glm::dvec3(0, 0, 1)), 1e-3);
    EXPECT_EQ(best.actions->text(), "2 slides");
    EXPECT_EQ(best.actions->weight, 2.0);
  }
}

TEST(SweepActions, AreTheSameWhateverTheThreads) {
  SweepSettings settings;
  settings.directions = 60;
  settings.refine = 1;
  settings.top = 4;
  settings.objective = parse_objective("undercut:1,side-actions:0.1,travel:0.1");
  settings.jobs = 1;
  const SweepResult one = sweep_of(block(), settings);
  settings.jobs = 3;
  const SweepResult three = sweep_of(block(), settings);
  ASSERT_EQ(one.candidates.size(), three.candidates.size());
  for (std::size_t k = 0; k < one.candidates.size(); ++k) {
    EXPECT_EQ(one.candidates[k].candidate.direction, three.candidates[k].candidate.direction);
    EXPECT_EQ(one.candidates[k].figures, three.candidates[k].figures);
    EXPECT_EQ(one.candidates[k].actions->text(), three.candidates[k].actions->text());
  }
}

TEST(DirectionActions, AreSummedUpByKinds) {
  ActionPlan plan;
  plan.unreleased_area = 2.5;
  EXPECT_EQ(direction_actions(plan, {}).text(), "none");
  EXPECT_EQ(direction_actions(plan, {}).weight, 0.0);
  for (const auto& [kind, travel] :
       {std::pair(ActionKind::lifter, 2.0), std::pair(ActionKind::slide, 7.0),
        std::pair(ActionKind::lifter, 3.0), std::pair(ActionKind::lifter, 1.0)}) {
    SideAction action;
    action.kind = kind;
    action.travel = travel;
    plan.actions.push_back(action);
  }
  const DirectionActions found = direction_actions(plan, {});
  EXPECT_EQ(found.text(), "1 slide, 3 lifters");
  EXPECT_EQ(found.weight, 4.6) << "to the last digit";
  EXPECT_EQ(found.travel, 7.0) << "the farthest";
  EXPECT_EQ(found.totals.unreleased_area, 2.5);
}

SideAction action(ActionKind kind, double area, std::vector<std::size_t> undercuts = {}) {
  SideAction made;
  made.kind = kind;
  made.area = area;
  made.undercuts = std::move(undercuts);
  return made;
}

TEST(DirectionActions, CountInsertsForTriflesByWhatTheyForm) {
  ActionPlan plan;
  for (const double area : {0.25, 0.5, 1.0, 7.0}) plan.actions.push_back(action(ActionKind::insert, area));
  plan.actions.push_back(action(ActionKind::slide, 0.25));
  Classification split;
  split.total_area = 1000.0;
  const DirectionActions found = direction_actions(plan, split);
  EXPECT_EQ(found.weight, 13.0);
  EXPECT_DOUBLE_EQ(found.in_vain, 3.0 * (0.75 + 0.5));
}

TEST(DirectionActions, CountActionsByTheShareReleasedOfTheirUndercuts) {
  ActionPlan plan;
  plan.undercuts.resize(2);
  for (UndercutReport& noted : plan.undercuts) noted.undercut.area = 40.0;
  plan.unreleased = {1};
  plan.unreleased_areas = {30.0};
  plan.actions = {action(ActionKind::slide, 45.0, {0, 1}), action(ActionKind::lifter, 5.0, {1})};
  Classification split;
  split.total_area = 1000.0;
  EXPECT_DOUBLE_EQ(direction_actions(plan, split).in_vain, 0.75 * 1.2);
}

TEST(DirectionActions, MoreThanAreBuiltReleaseNothing) {
  ActionPlan plan;
  for (int k = 0; k < 10; ++k) plan.actions.push_back(action(ActionKind::slide, 20.0 - k));
  Classification split;
  split.total_area = 1000.0;
  const DirectionActions found = direction_actions(plan, split);
  EXPECT_EQ(found.weight, 10.0);
  EXPECT_DOUBLE_EQ(found.in_vain, 2.0) << "those that form least";
  EXPECT_DOUBLE_EQ(found.beyond, 12.0 + 11.0);
  EXPECT_DOUBLE_EQ(found.formed_area, 132.0);
}

TEST(ActionLimit, WhatMoreThanAreBuiltWouldFormIsLeft) {
  const ActionLimit limit{.left = 50.0, .left_band = 10.0};
  EXPECT_TRUE(limit.is_exceeded({.weight = 9.0, .beyond = 61.0}, {.count = 20, .area = 500.0}));
  EXPECT_FALSE(limit.is_exceeded({.weight = 9.0, .beyond = 59.0}, {.count = 20, .area = 500.0}));
}

TEST(ActionLimit, ManyUndercutsAreGivenUpWhereTheyAreTooLarge) {
  const ActionLimit limit{.most_of_many = 100.0};
  EXPECT_TRUE(limit.is_exceeded({}, {.count = 41, .area = 101.0}));
  EXPECT_FALSE(limit.is_exceeded({}, {.count = 41, .area = 99.0}));
  EXPECT_FALSE(limit.is_exceeded({}, {.count = 40, .area = 101.0}));
}

TEST(ActionLimit, MoreUndercutThanBesideAnAxisIsGivenUpUnlessItIsSpecks) {
  const ActionLimit limit{.most_undercut = 60.0};
  EXPECT_TRUE(limit.is_exceeded({}, {.count = 1, .area = 61.0}));
  EXPECT_FALSE(limit.is_exceeded({}, {.count = 1, .area = 59.0}));
  EXPECT_FALSE(limit.is_exceeded({}, {.count = 0, .area = 61.0}));
}

}  // namespace
}  // namespace moldlight
