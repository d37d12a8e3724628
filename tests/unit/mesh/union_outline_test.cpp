// Outlines of triangles in a plane, against areas that are known and against points that are counted.
#include "mesh/union_outline.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace moldlight {
namespace {

struct Flat {
  std::vector<glm::dvec2> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  void square(const glm::dvec2& low, double side, bool turned = false) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
      points.push_back(low + side * corner);
    for (const std::array<std::uint32_t, 3> each : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      triangles.push_back({first + each[0], first + each[turned ? 2 : 1], first + each[turned ? 1 : 2]});
    }
  }
};

bool inside(const std::vector<std::vector<glm::dvec2>>& loops, const glm::dvec2& at) {
  bool in = false;
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const glm::dvec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
  }
  return in;
}

bool covered(const Flat& flat, const glm::dvec2& at) {
  return std::ranges::any_of(flat.triangles, [&](const auto& corners) {
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 &a = flat.points[corners[k]], &b = flat.points[corners[(k + 1) % 3]];
      ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x) > 0.0 ? left : right) += 1;
    }
    return left == 0 || right == 0;
  });
}

TEST(UnionOutline, OfASquareAreItsFourCorners) {
  Flat flat;
  flat.square({0.1, 0.2}, 0.5);
  const auto loops = union_outline(flat.points, flat.triangles);
  ASSERT_TRUE(loops);
  ASSERT_EQ(loops->size(), 1U);
  EXPECT_EQ(loops->front().size(), 4U);
  EXPECT_NEAR(enclosed_area(*loops), 0.25, 1e-12);
}

TEST(UnionOutline, OfSheetsOverEachOtherIsThatOfOne) {
  Flat flat;
  flat.square({0, 0}, 0.5);
  flat.square({1e-8, -1e-8}, 0.5, true);
  flat.square({0.1, 0.1}, 0.2);
  const auto loops = union_outline(flat.points, flat.triangles);
  ASSERT_TRUE(loops);
  EXPECT_EQ(loops->size(), 1U);
  EXPECT_NEAR(enclosed_area(*loops), 0.25, 1e-6);
}

TEST(UnionOutline, OfSquaresThatCrossIsAStar) {
  Flat flat;
  flat.square({0, 0}, 0.4);
  flat.square({0.2, 0.2}, 0.4, true);
  const auto loops = union_outline(flat.points, flat.triangles);
  ASSERT_TRUE(loops);
  ASSERT_EQ(loops->size(), 1U);
  EXPECT_EQ(loops->front().size(), 8U);
  EXPECT_NEAR(enclosed_area(*loops), 0.28, 1e-9);
}

TEST(UnionOutline, LeavesAHoleOut) {
  Flat flat;
  for (int k = 0; k < 9; ++k) {
    if (k != 4) flat.square({0.1 * (k % 3), 0.1 * (k / 3)}, 0.1);
  }
  const auto loops = union_outline(flat.points, flat.triangles);
  ASSERT_TRUE(loops);
  ASSERT_EQ(loops->size(), 2U);
  EXPECT_EQ((*loops)[1].size(), 4U);
  EXPECT_LT(enclosed_area(std::span(&(*loops)[1], 1)), 0.0) << "it runs the other way";
  EXPECT_NEAR(enclosed_area(*loops), 0.08, 1e-9);
}

TEST(UnionOutline, OfTrianglesThrownAtRandomHoldsWhatTheyCover) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.5, 0.5), reach(-0.2, 0.2);
  int noted = 0;
  for (int round = 0; round < 40; ++round) {
    Flat flat;
    for (std::uint32_t k = 0; k < 25; ++k) {
      const glm::dvec2 at(place(random), place(random));
      for (int corner = 0; corner < 3; ++corner)
        flat.points.push_back(at + glm::dvec2(reach(random), reach(random)));
      flat.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const auto loops = union_outline(flat.points, flat.triangles);
    if (!loops) continue;
    ++noted;
    int wrong = 0;
    for (int k = 0; k < 2000; ++k) {
      const glm::dvec2 at(place(random), place(random));
      wrong += inside(*loops, at) != covered(flat, at) ? 1 : 0;
    }
    EXPECT_LE(wrong, 1) << "round " << round;
  }
  EXPECT_EQ(noted, 40);
}

TEST(UnionOutline, IsNotToldForMoreSidesThanAllowed) {
  Flat flat;
  for (int k = 0; k < 10; ++k) flat.square({0.15 * k - 1.0, 0.0}, 0.1);
  EXPECT_FALSE(union_outline(flat.points, flat.triangles, 39));
  EXPECT_TRUE(union_outline(flat.points, flat.triangles, 40));
}

}  // namespace
}  // namespace moldlight
