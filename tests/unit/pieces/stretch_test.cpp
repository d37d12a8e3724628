// What flexible pieces ask for, on solids whose necks and tunnels are known.
#include "pieces/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "pieces/find_pieces.hpp"
#include "pieces/pieces_report.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

PiecesResult flexible(const PartModel& model, std::vector<glm::dvec3> directions) {
  PiecesSettings settings{
      .most = static_cast<int>(directions.size()), .fixed = std::move(directions), .elongation_pct = 300.0};
  return find_pieces(model, {}, settings, Progress());
}
PiecesResult flexible_along_z(const TriangleMesh& mesh) {
  return flexible(*test::model_of(mesh), {{0, 0, 1}, {0, 0, -1}});
}
std::size_t cuts_of(const PiecesResult& result) {
  std::size_t cuts = 0;
  for (const std::size_t one : result.cuts.value()) cuts += one;
  return cuts;
}

constexpr int k_stem_sides = 36;
double perimeter(double radius) {
  return 2.0 * k_stem_sides * radius * std::sin(std::numbers::pi / k_stem_sides);
}

/// A mushroom on a plate: stem of radius 5, cap of radius 12, plate of radius 20.
TriangleMesh mushroom() {
  const auto ring = [](double radius, double z) {
    return test::at_height(test::regular_polygon(k_stem_sides, radius), z);
  };
  const auto turned = [](test::Loop loop) {
    std::ranges::reverse(loop);
    return loop;
  };
  test::SolidBuilder builder;
  builder.face(turned(ring(20, 0)));
  builder.walls(ring(20, 0), ring(20, 4));
  builder.face(ring(20, 4), {ring(5, 4)});
  builder.walls(ring(5, 4), ring(5, 16));
  builder.face(turned(ring(12, 16)), {ring(5, 16)});
  builder.walls(ring(12, 16), ring(12, 20));
  builder.face(ring(12, 20));
  return builder.mesh();
}

TEST(Stretch, AMushroomsNeckIsItsStem) {
  const PiecesResult result = flexible_along_z(mushroom());
  EXPECT_EQ(pieces_state(result), "stretched");
  ASSERT_EQ(result.stretches.size(), 1U);
  const StretchedUndercut& stretch = result.stretches[0];
  EXPECT_EQ(stretch.direction, 0U);  // over the cap; the plate is wider
  ASSERT_TRUE(stretch.neck && stretch.depth);
  EXPECT_NEAR(stretch.neck->perimeter, perimeter(5), 1e-4);
  EXPECT_NEAR(stretch.neck->widest, perimeter(12), 1e-4);
  EXPECT_NEAR(stretch.neck->strain(), 12.0 / 5.0 - 1.0, 1e-5);
  const double middle = std::cos(std::numbers::pi / k_stem_sides);  // of a side
  EXPECT_NEAR(*stretch.depth, 7.0 * middle, 0.02);
  EXPECT_EQ(cuts_of(result), 0U);
  // All of the surface is formed by a piece.
  EXPECT_LT(std::ranges::max(result.formed.formed_by), 2U);
}

TEST(Stretch, StaysWhenThePartIsTurned) {
  const glm::dquat turn = test::random_rotation(3);
  const auto model = test::model_of(test::rotated(mushroom(), turn));
  const glm::dvec3 up = turn * glm::dvec3(0, 0, 1);
  const PiecesResult result = flexible(*model, {-up, up});
  ASSERT_EQ(result.stretches.size(), 1U);
  EXPECT_EQ(result.stretches[0].direction, 1U);
  EXPECT_NEAR(result.stretches[0].neck.value().strain(), 1.4, 1e-4);
}

/// 6 by 20 at its mouth, 20 by 24 inside, closed at both ends.
TEST(Stretch, ASlotsThroatIsItsMouth) {
  test::SolidBuilder builder;
  const glm::dvec3 mouth_low(-3, -10, 12), mouth_high(3, 10, 20), room_low(-10, -12, 4),
      room_high(10, 12, 12);
  builder.box({-20, -20, 0}, {20, 20, 20}, {5});
  builder.face(test::box_face({-20, -20, 0}, {20, 20, 20}, 5), {test::box_face(mouth_low, mouth_high, 5)});
  builder.box(mouth_low, mouth_high, {4, 5}, true);
  builder.box(room_low, room_high, {5}, true);
  test::Loop ceiling = test::box_face(room_low, room_high, 5);
  std::ranges::reverse(ceiling);
  builder.face(ceiling, {test::box_face(mouth_low, mouth_high, 4)});
  const PiecesResult result = flexible_along_z(builder.mesh());
  ASSERT_EQ(result.stretches.size(), 1U);
  ASSERT_TRUE(result.stretches[0].neck && result.stretches[0].depth);
  EXPECT_NEAR(result.stretches[0].neck->perimeter, 2.0 * (6 + 20), 1e-4);
  EXPECT_NEAR(result.stretches[0].neck->widest, 2.0 * (20 + 24), 1e-4);
  EXPECT_NEAR(*result.stretches[0].depth, 7.0, 0.6);
  EXPECT_GE(*result.stretches[0].depth, 7.0 - 0.02);
}

/// A screw's thread has the same outline at every height, turned: straight along the axis it is in the way
/// all round. The outlines are a circle with a bump.
TEST(Stretch, AThreadIsInTheWayAllRound) {
  constexpr int k_rings = 24;
  const auto ring = [](double z) {
    test::Loop2 loop;
    for (int k = 0; k < 2 * k_stem_sides; ++k) {
      const double angle = std::numbers::pi * k / k_stem_sides;
      const double bump = std::max(0.0, std::cos(angle - 0.25 * std::numbers::pi * z));
      loop.push_back((10.0 + 1.5 * bump) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return test::at_height(loop, z);
  };
  TriangleMesh mesh;
  for (int row = 0; row <= k_rings; ++row)
    for (const glm::dvec3& point : ring(row)) mesh.vertices.push_back(point);
  const auto at = [](int row, int k) {
    return static_cast<VertexIndex>(row * 2 * k_stem_sides + k % (2 * k_stem_sides));
  };
  for (int k = 0; k < 2 * k_stem_sides; ++k) {
    for (int row = 0; row < k_rings; ++row) {
      mesh.facets.push_back({at(row, k), at(row, k + 1), at(row + 1, k + 1)});
      mesh.facets.push_back({at(row, k), at(row + 1, k + 1), at(row + 1, k)});
    }
    if (k < 2) continue;
    mesh.facets.push_back({at(0, 0), at(0, k), at(0, k - 1)});
    mesh.facets.push_back({at(k_rings, 0), at(k_rings, k - 1), at(k_rings, k)});
  }
  const PiecesResult result = flexible_along_z(mesh);
  ASSERT_FALSE(result.stretches.empty());
  ASSERT_TRUE(result.stretches[0].neck);
  EXPECT_NEAR(result.stretches[0].neck->widest, 2.0 * std::numbers::pi * 11.5, 0.6);
  EXPECT_LT(result.stretches[0].neck->perimeter, 2.0 * std::numbers::pi * 10.9);
}

/// A dimple in a wall does not go round anything: it comes out sideways.
TEST(Stretch, ASidePocketHasADepthAlone) {
  const test::Shape shape = test::plate_with_side_pocket({});
  const auto model = test::model_of(shape.mesh);
  const PiecesResult result = flexible(*model, {shape.direction, -shape.direction});
  ASSERT_FALSE(result.stretches.empty());
  EXPECT_FALSE(result.stretches[0].neck);
  EXPECT_GT(result.stretches[0].depth.value_or(0.0), 0.5);
}

TEST(Stretch, NothingLeadsIntoAHollow) {
  const PiecesResult result = flexible_along_z(test::hollow_sphere({}).mesh);
  ASSERT_FALSE(result.stretches.empty());
  EXPECT_FALSE(result.stretches[0].neck || result.stretches[0].depth);
}

/// Lying, the ring comes out between the halves; upright, one of them goes through it; with halves to its
/// sides none does.
TEST(Stretch, AnUprightRingAsksForOneCut) {
  const test::Shape ring = test::ring({});
  const auto model = test::model_of(ring.mesh);
  const glm::dvec3 axis = ring.direction;
  EXPECT_EQ(cuts_of(flexible(*model, {axis, -axis})), 0U);
  const glm::dvec3 across =
      glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const PiecesResult upright = flexible(*model, {across, -across});
  EXPECT_EQ(cuts_of(upright), 1U);
  EXPECT_NE(pieces_sentence(*model, upright).find("1 loop of the pieces goes through a tunnel"),
            std::string::npos)
      << pieces_sentence(*model, upright);
}

/// Two holes that cross in a block, one of them along the direction.
TEST(Stretch, CrossingHolesAskForACutWhereTheyRunAcross) {
  const test::Shape block = test::block_with_crossing_hole({});
  const auto model = test::model_of(block.mesh);
  EXPECT_EQ(cuts_of(flexible(*model, {block.direction, -block.direction})), 1U);
}

TEST(Stretch, WhatRigidHalvesReleaseAsksForNoCut) {
  for (const test::Shape& shape : {test::plate_with_through_hole({}), test::ring({}), test::l_bracket({})}) {
    const auto model = test::model_of(shape.mesh);
    EXPECT_EQ(cuts_of(flexible(*model, {shape.direction, -shape.direction})), 0U) << shape.name;
  }
}

TEST(Stretch, RigidMoldsHaveNone) {
  PiecesSettings settings{.most = 2, .fixed = {{0, 0, 1}, {0, 0, -1}}};
  const auto model = test::model_of(mushroom());
  const PiecesResult result = find_pieces(*model, {}, settings, Progress());
  EXPECT_TRUE(result.stretches.empty());
  EXPECT_FALSE(result.cuts);
  EXPECT_EQ(pieces_state(result), "left-over");
}

}  // namespace
}  // namespace moldlight
