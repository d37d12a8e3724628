// The highest surface of triangles over an outline.
#include "mesh/polygon_lift.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/polygon_triangulation.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

using Cap = std::vector<std::array<std::uint32_t, 3>>;

Cap lifted(const std::vector<glm::dvec3>& outline, const glm::dvec3& up) {
  Cap cap;
  PolygonTriangulator(1'000'000).triangulate(outline, cap);
  lift_triangles(outline, up, cap);
  return cap;
}

double seen_area(const std::vector<glm::dvec3>& outline, const Cap& cap) {
  double area = 0.0;
  for (const auto& [a, b, c] : cap) {
    const double its = 0.5 * glm::cross(outline[b] - outline[a], outline[c] - outline[a]).z;
    EXPECT_GT(its, 0.0);
    area += its;
  }
  return area;
}

TEST(PolygonLift, OverAConvexOutlineIsTheUpperHull) {
  test::Random random{7};
  for (int trial = 0; trial < 200; ++trial) {
    const int corners = 4 + trial % 20;
    std::vector<glm::dvec3> outline;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + random.between(-0.3, 0.3)) / corners;
      outline.emplace_back(std::cos(angle), std::sin(angle), random.between(-1.0, 1.0));
    }
    Cap plain;
    PolygonTriangulator(1'000'000).triangulate(outline, plain);
    const Cap cap = lifted(outline, {0, 0, 1});
    ASSERT_EQ(cap.size(), plain.size());
    EXPECT_NEAR(seen_area(outline, cap), seen_area(outline, plain), 1e-12);
    for (const auto& [a, b, c] : cap) {
      const glm::dvec3 plane = glm::cross(outline[b] - outline[a], outline[c] - outline[a]);
      for (const glm::dvec3& other : outline) EXPECT_LE(glm::dot(plane, other - outline[a]), 1e-8);
    }
  }
}

/// A notch in the outline stays one, and no triangle lies over it.
TEST(PolygonLift, OverANotchedOutlineKeepsTheNotch) {
  const std::vector<glm::dvec3> outline = {{0, 0, 0}, {4, 0, 0.2}, {4, 4, 0}, {2, 1, 0.5}, {0, 4, 0.1}};
  Cap plain;
  PolygonTriangulator(1'000'000).triangulate(outline, plain);
  EXPECT_NEAR(seen_area(outline, lifted(outline, {0, 0, 1})), seen_area(outline, plain), 1e-12);
}

}  // namespace
}  // namespace moldlight
