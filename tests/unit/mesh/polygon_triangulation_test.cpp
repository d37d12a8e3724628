#include "mesh/polygon_triangulation.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/mesh_edits.hpp"

namespace moldlight {
namespace {

constexpr std::uint64_t k_much_work = 1'000'000'000;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Outline = std::vector<glm::dvec3>;

Outline star(int corners) {
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners, radius = i % 2 == 0 ? 2.0 : 1.0;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return outline;
}

/// Teeth of width 1 on a back of height 1.
Outline comb(int teeth, double length) {
  Outline outline = {{0, -1, 0}, {2.0 * teeth - 1.0, -1, 0}};
  for (int tooth = teeth - 1; tooth >= 0; --tooth) {
    const double x = 2.0 * tooth;
    outline.insert(outline.end(), {{x + 1, length, 0}, {x, length, 0}});
    if (tooth > 0) outline.insert(outline.end(), {{x, 0, 0}, {x - 1, 0, 0}});
  }
  return outline;
}

/// A band wound up, in by its outer side and out by its inner one.
Outline spiral(int corners, double turns) {
  Outline outline;
  const auto at = [&](int i, double offset) {
    const double share = static_cast<double>(i) / corners, angle = 2.0 * std::numbers::pi * turns * share;
    const double radius = 1.0 + turns * share + offset;
    return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  };
  for (int i = 0; i < corners; ++i) outline.push_back(at(i, 0.4));
  for (int i = corners - 1; i >= 0; --i) outline.push_back(at(i, 0.0));
  return outline;
}

double area_of(const Outline& outline) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    sum += glm::cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return 0.5 * glm::length(sum);
}

/// The triangles' areas, each taken for positive, so that overlaps would show.
double area_of(const Outline& outline, const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
    sum += 0.5 * glm::length(glm::cross(outline[b] - outline[a], outline[c] - outline[a]));
  return sum;
}

void expect_cut(const Outline& flat, const char* name) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const glm::dquat rotation = seed == 0 ? glm::dquat(1, 0, 0, 0) : test::random_rotation(seed);
    Outline outline;
    for (const glm::dvec3& corner : flat) outline.push_back(rotation * corner);
    PolygonTriangulator triangulator(k_much_work);
    Triangles triangles;
    EXPECT_EQ(triangulator.triangulate(outline, triangles), PolygonCut::ears) << name;
    ASSERT_EQ(triangles.size(), outline.size() - 2) << name;
    EXPECT_NEAR(area_of(outline, triangles), area_of(outline), 1e-9 * area_of(outline)) << name;
  }
}

TEST(PolygonTriangulation, LongOutlinesAreCutWithoutOverlaps) {
  expect_cut(star(10000), "star");
  expect_cut(comb(5000, 100.0), "comb");
  expect_cut(spiral(3000, 20.0), "spiral");
}

TEST(PolygonTriangulation, AStarOfTenThousandCornersTakesLittleWork) {
  // A hundred steps a corner, where looking at every corner for every ear would take ten thousand.
  PolygonTriangulator triangulator(1'000'000);
  const Outline outline = star(10000);
  Triangles triangles;
  EXPECT_EQ(triangulator.triangulate(outline, triangles), PolygonCut::ears);
  EXPECT_NEAR(area_of(outline, triangles), 10000 * std::sin(2.0 * std::numbers::pi / 10000), 1e-9);
}

TEST(PolygonTriangulation, ExtentDoesNotMatter) {
  for (const double scale : {1e-310, 1e-160, 1e-20, 1e20, 1e120}) {
    Outline outline = star(40);
    for (glm::dvec3& corner : outline) corner *= scale;
    PolygonTriangulator triangulator(k_much_work);
    Triangles triangles;
    static_cast<void>(triangulator.triangulate(outline, triangles));
    EXPECT_EQ(triangles.size(), 38U) << scale;
  }
}

TEST(PolygonTriangulation, WorkEndsAtItsLimit) {
  PolygonTriangulator triangulator(1000);
  Triangles triangles;
  EXPECT_EQ(triangulator.triangulate(star(10000), triangles), PolygonCut::fan_of_odd);
  EXPECT_EQ(triangles.size(), 9998U);
}

TEST(PolygonTriangulation, OutlinesThatCrossThemselvesAreOdd) {
  PolygonTriangulator triangulator(k_much_work);
  Triangles triangles;
  const Outline bow_tie = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulator.triangulate(bow_tie, triangles), PolygonCut::fan_of_odd);
  EXPECT_EQ(triangles.size(), 2U);
}

TEST(PolygonTriangulation, AHoleJoinedByABridgeIsCut) {
  // A square with a square hole, whose bridge is run through twice.
  const Outline outline = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                           {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  PolygonTriangulator triangulator(k_much_work);
  Triangles triangles;
  EXPECT_EQ(triangulator.triangulate(outline, triangles), PolygonCut::ears);
  EXPECT_NEAR(area_of(outline, triangles), 12.0, 1e-12);
}

}  // namespace
}  // namespace moldlight
