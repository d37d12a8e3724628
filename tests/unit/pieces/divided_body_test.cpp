// Solids cut by planes, and bodies that move out in shares.
#include "pieces/divided_body.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "parting/halves/bodies.hpp"
#include "parting/slide_blank.hpp"
#include "pieces/plane_cut.hpp"
#include "support/boxes.hpp"
#include "support/random.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

/// A square plate with a square hole, upright.
TriangleMesh frame_shape(double half, double hole, double high) {
  test::SolidBuilder builder;
  const test::Loop2 outer = {{-half, -half}, {half, -half}, {half, half}, {-half, half}},
                    inner = {{-hole, -hole}, {hole, -hole}, {hole, hole}, {-hole, hole}};
  builder.face(test::at_height(outer, high), {test::at_height(inner, high)});
  test::Loop under = test::at_height(outer, 0.0);
  std::ranges::reverse(under);
  builder.face(under, {test::at_height(inner, 0.0)});
  builder.walls(test::at_height(outer, 0.0), test::at_height(outer, high));
  builder.walls(test::at_height(inner, high), test::at_height(inner, 0.0));
  return builder.mesh();
}

double volume_of(const TriangleMesh& mesh) {
  const BodyCheck check = check_body(mesh.vertices, mesh.facets);
  EXPECT_EQ(check.open_edges, 0U);
  return check.volume;
}
double volume_of(const std::vector<TriangleMesh>& bodies) {
  double sum = 0.0;
  for (const TriangleMesh& body : bodies) {
    EXPECT_GT(volume_of(body), 0.0);
    sum += volume_of(body);
  }
  return sum;
}

TEST(PlaneCut, ParallelToAFaceHasTheVolumesOfBothParts) {
  const TriangleMesh frame = frame_shape(0.4, 0.1, 0.2);
  const auto level = cut_solid(frame, {{0, 0, 1}, 0.05});
  ASSERT_TRUE(level);
  EXPECT_EQ(level->inside.size(), 1U);
  EXPECT_NEAR(volume_of(level->inside), 0.05 * (0.64 - 0.04), 1e-14);
  EXPECT_NEAR(volume_of(level->outside), 0.15 * (0.64 - 0.04), 1e-14);
  // Through the hole: one side is in one piece, the other too.
  const auto upright = cut_solid(frame, {{1, 0, 0}, 0.02});
  ASSERT_TRUE(upright);
  EXPECT_EQ(upright->inside.size() + upright->outside.size(), 2U);
  EXPECT_NEAR(volume_of(upright->inside), 0.2 * (0.42 * 0.8 - 0.12 * 0.2), 1e-14);
}

TEST(PlaneCut, SharesOfRandomCutsMakeUpTheSolid) {
  test::Random random(11);
  test::SolidBuilder builder;
  builder.extrude(
      {{-0.4, 0.0}, {0.4, 0.0}, {0.4, 0.4}, {0.3, 0.4}, {0.3, 0.1}, {-0.3, 0.1}, {-0.3, 0.4}, {-0.4, 0.4}},
      {}, 0.2);
  const TriangleMesh fork = builder.mesh();
  const double whole = volume_of(fork);
  std::size_t parted = 0;
  for (int k = 0; k < 200; ++k) {
    const auto cut = cut_solid(fork, {glm::normalize(random.in_cube(1.0)), random.between(-0.3, 0.4)});
    ASSERT_TRUE(cut);
    EXPECT_NEAR(volume_of(cut->inside) + volume_of(cut->outside), whole, 1e-14);
    parted += cut->inside.size() > 1 || cut->outside.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(parted, 0U) << "some fall into several bodies";
}

TEST(PlaneCut, APlaneThroughACornerIsNotTaken) {
  EXPECT_FALSE(cut_solid(frame_shape(0.4, 0.1, 0.2), {{1, 0, 0}, 0.1}));
}

/// A ring around a post comes off in two halves.
TEST(DividedBody, ARingAroundAPostIsPartedBesideThePost) {
  const TriangleMesh post = test::box_mesh({-0.05, -0.05, -0.3}, {0.05, 0.05, 0.5}),
                     ring = frame_shape(0.2, 0.0501, 0.1);
  const DivisionTask task{.part = post, .ways = {{3, {1, 0, 0}}, {7, {-1, 0, 0}}}, .tolerance = 1.0 / 2048.0};
  const std::vector<BodyShare> shares = divided_body(task, ring, Progress());
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_NE(shares[0].direction, shares[1].direction);
  double volume = 0.0;
  for (const BodyShare& share : shares) {
    ASSERT_TRUE(share.direction == 3U || share.direction == 7U);
    const glm::dvec3 way(share.direction == 3U ? 1 : -1, 0, 0);
    EXPECT_LE(way_out(share.mesh, post, way).blocked, task.tolerance);
    volume += volume_of(share.mesh);
  }
  EXPECT_NEAR(volume, volume_of(ring), 1e-14);
  const glm::dvec3 first(shares[0].direction == 3U ? 1 : -1, 0, 0);
  EXPECT_LT(way_out(shares[0].mesh, shares[1].mesh, first).blocked, 1e-12);
}

TEST(DividedBody, WhatMovesOutOrDoesNotAtAllStaysWhole) {
  const TriangleMesh wall = test::box_mesh({0.1, -0.5, -0.5}, {0.15, 0.5, 0.5}),
                     body = test::box_mesh({-0.1, -0.1, -0.1}, {0.0999, 0.1, 0.1});
  const auto shares = [&](const glm::dvec3& way) {
    return divided_body({.part = wall, .ways = {{0, way}}, .tolerance = 1.0 / 2048.0}, body, Progress());
  };
  ASSERT_EQ(shares({-1, 0, 0}).size(), 1U);
  EXPECT_EQ(shares({-1, 0, 0})[0].direction, 0U);
  ASSERT_EQ(shares({1, 0, 0}).size(), 1U);
  EXPECT_EQ(shares({1, 0, 0})[0].direction, std::nullopt);
}

}  // namespace
}  // namespace moldlight
