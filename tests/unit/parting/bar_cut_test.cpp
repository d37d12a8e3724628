// Solids divided by a room.
#include "parting/bar_cut.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "parting/halves/bodies.hpp"
#include "support/boxes.hpp"
#include "support/curved_solids.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

/// A bar of a rectangular section at z = 0, that leans along x.
BarRoom bar(const glm::dvec2& low, const glm::dvec2& high, double lean) {
  const glm::dvec3 along = glm::normalize(glm::dvec3(lean, 0.0, 1.0));
  const double cosine = along.z;
  const glm::dvec3 x(cosine, 0.0, -along.x), y(0, 1, 0);
  return {.along = along,
          .sides = {HalfSpace{-x, -cosine * low.x}, HalfSpace{-y, -low.y}, HalfSpace{x, cosine * high.x},
                    HalfSpace{y, high.y}}};
}

void expect_divided(const TriangleMesh& solid, const BarCut& cut, double inside) {
  for (const TriangleMesh* part : {&cut.inside, &cut.outside}) {
    const BodyCheck check = check_body(part->vertices, part->facets);
    EXPECT_EQ(check.open_edges, 0U);
    EXPECT_EQ(check.nonmanifold_edges, 0U);
  }
  EXPECT_NEAR(signed_volume(cut.inside), inside, 1e-9);
  EXPECT_NEAR(signed_volume(cut.inside) + signed_volume(cut.outside), signed_volume(solid), 1e-9);
}

TEST(BarCut, TakesALeaningBarOutOfABlock) {
  const TriangleMesh block = test::box_mesh({0, 0, 0}, {10, 8, 6});
  const auto cut = cut_by_bar(block, bar({2, 3}, {4, 5}, 0.3), 10.0);
  ASSERT_TRUE(cut);
  expect_divided(block, *cut, 2.0 * 2.0 * 6.0);
}

TEST(BarCut, TakesWhatOfTheBarIsInTheBlock) {
  const TriangleMesh block = test::box_mesh({0, 0, 0}, {10, 8, 6});
  // It leaves through the wall at x = 10 between the heights 2 and 4.
  const auto cut = cut_by_bar(block, bar({8, 3}, {9, 5}, 0.5), 10.0);
  ASSERT_TRUE(cut);
  expect_divided(block, *cut, 2.0 * (2.0 + 0.5 * 2.0));
}

TEST(BarCut, EndsInTheSolid) {
  const TriangleMesh block = test::box_mesh({0, 0, 0}, {10, 8, 6});
  BarRoom room = bar({2, 3}, {4, 5}, 0.3);
  room.end = HalfSpace{{0, 0, -1}, -2.0};
  const auto cut = cut_by_bar(block, room, 10.0);
  ASSERT_TRUE(cut);
  expect_divided(block, *cut, 2.0 * 2.0 * 4.0);
}

TEST(BarCut, EndsWhereTheSolidIsInPart) {
  // Its end is over the step of an L, half in the material.
  test::SolidBuilder solid;
  solid.extrude({{0, 0}, {10, 0}, {10, 3}, {3, 3}, {3, 6}, {0, 6}}, {}, 8.0);
  const TriangleMesh step = solid.mesh();
  BarRoom room = bar({2, 3}, {4, 5}, 0.0);
  room.end = HalfSpace{{0, 0, -1}, -4.0};
  const auto cut = cut_by_bar(step, room, 10.0);
  ASSERT_TRUE(cut);
  expect_divided(step, *cut, 1.0 * 2.0 * 2.0);
  room.end = HalfSpace{{0, 0, -1}, -2.0};
  const auto deeper = cut_by_bar(step, room, 10.0);
  ASSERT_TRUE(deeper);
  expect_divided(step, *deeper, 2.0 * 2.0 * 1.0 + 1.0 * 2.0 * 3.0);
}

TEST(BarCut, TakesAPinOfManySides) {
  const TriangleMesh block = test::box_mesh({0, 0, 0}, {10, 8, 6});
  BarRoom room{.along = {0, 0, 1}, .sides = {}, .end = HalfSpace{{0, 0, -1}, -1.0}};
  constexpr int k_sides = 24;
  for (int k = 0; k < k_sides; ++k) {
    const double angle = 2.0 * M_PI * k / k_sides;
    const glm::dvec3 normal(std::cos(angle), std::sin(angle), 0.0);
    room.sides.push_back({normal, 2.0 + glm::dot(normal, glm::dvec3(5, 4, 0))});
  }
  const auto cut = cut_by_bar(block, room, 10.0);
  ASSERT_TRUE(cut);
  expect_divided(block, *cut, k_sides * 4.0 * std::tan(M_PI / k_sides) * 5.0);
}

TEST(BarCut, LeavesASolidThatItMisses) {
  const TriangleMesh block = test::box_mesh({0, 0, 0}, {10, 8, 6});
  const auto cut = cut_by_bar(block, bar({20, 3}, {21, 5}, 0.0), 10.0);
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->inside.facets.empty());
  EXPECT_EQ(cut->outside.facets.size(), block.facets.size());
}

/// Walls with two rims, and with a hole.
TEST(BarCut, DividesATorus) {
  TriangleMesh torus = test::torus_mesh(10.0, 3.0, 48, 24);
  for (FacetIndex facet = 0; facet < torus.facets.size(); ++facet) test::reverse_facet(torus, facet);
  ASSERT_GT(signed_volume(torus), 0.0);
  for (const double lean : {0.0, 0.2}) {
    const auto cut = cut_by_bar(torus, bar({-11.3, -14.7}, {9.1, 2.3}, lean), 20.0);
    ASSERT_TRUE(cut);
    expect_divided(torus, *cut, signed_volume(cut->inside));
    EXPECT_GT(signed_volume(cut->inside), 0.3 * signed_volume(torus));
    EXPECT_LT(signed_volume(cut->inside), 0.7 * signed_volume(torus));
  }
}

}  // namespace
}  // namespace moldlight
