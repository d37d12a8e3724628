// The constrained triangulation against its definition.
#include "parting/halves/plane_mesh.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "parting/halves/sheets.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

using Triangle = PlaneMesh::Triangle;

double area(const PlaneMesh& mesh, const Triangle& t) {
  const glm::dvec2 a = mesh.points()[t.corners[0]], p = mesh.points()[t.corners[1]] - a,
                   q = mesh.points()[t.corners[2]] - a;
  return 0.5 * (p.x * q.y - p.y * q.x);
}

/// Covers the rectangle once, neighbours know each other, and no point lies in the circle of a triangle
/// unless a segment hides it.
void expect_sound(const PlaneMesh& mesh, double rectangle, bool delaunay) {
  double sum = 0.0;
  for (std::uint32_t number = 0; number < mesh.triangles().size(); ++number) {
    const Triangle& t = mesh.triangles()[number];
    const auto at = [&](std::size_t k) { return mesh.points()[t.corners[k % 3]]; };
    EXPECT_GT(PlaneMesh::side_of(at(0), at(1), at(2)), 0);
    sum += area(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.across[k] == PlaneMesh::k_none) continue;
      const Triangle& u = mesh.triangles()[t.across[k]];
      std::size_t back = 0;
      while (back < 3 && u.across[back] != number) ++back;
      ASSERT_LT(back, 3U);
      EXPECT_EQ(u.corners[back], t.corners[(k + 1) % 3]);
      EXPECT_EQ(u.corners[(back + 1) % 3], t.corners[k]);
      EXPECT_EQ(u.fixed[back], t.fixed[k]);
      if (!delaunay || t.fixed[k] != 0) continue;
      const glm::dvec2 far = mesh.points()[u.corners[(back + 2) % 3]];
      // Opposite angles of the two triangles sum up to half a turn at most.
      const auto angle = [](const glm::dvec2& tip, const glm::dvec2& a, const glm::dvec2& b) {
        return std::acos(glm::dot(glm::normalize(a - tip), glm::normalize(b - tip)));
      };
      EXPECT_LE(angle(at(k + 2), at(k), at(k + 1)) + angle(far, at(k), at(k + 1)), M_PI + 1e-5);
    }
  }
  EXPECT_NEAR(sum, rectangle, 1e-12);
}

TEST(PlaneMesh, IsDelaunay) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    PlaneMesh mesh({-1, -1}, {1, 1});
    for (int k = 0; k < 200; ++k) {
      // Many of them in rows and equal ones.
      const bool rows = seed % 2 == 0;
      const auto at = [&] {
        const double x = random.between(-1.0, 1.0);
        return rows ? std::round(8.0 * x) / 8.0 : x;
      };
      const double x = at(), y = at();
      static_cast<void>(mesh.add_point(on_grid({x, y})));
    }
    expect_sound(mesh, 4.0, true);
  }
}

TEST(PlaneMesh, KeepsSegments) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    PlaneMesh mesh({-1, -1}, {1, 1});
    // A star's outline, and points everywhere.
    std::vector<std::uint32_t> star;
    constexpr int k_tips = 60;
    for (int k = 0; k < k_tips; ++k) {
      const double turn = 2.0 * M_PI * k / k_tips, radius = k % 2 == 0 ? 0.9 : random.between(0.1, 0.6);
      star.push_back(mesh.add_point(on_grid(radius * glm::dvec2(std::cos(turn), std::sin(turn)))));
    }
    for (int k = 0; k < 100; ++k)
      static_cast<void>(mesh.add_point(on_grid({random.between(-1.0, 1.0), random.between(-1.0, 1.0)})));
    double expected = 0.0;
    for (std::size_t k = 0; k < star.size(); ++k) {
      const auto obstacle = mesh.add_segment(star[k], star[(k + 1) % star.size()], PlaneMesh::k_outline);
      EXPECT_FALSE(obstacle.has_value());
      const glm::dvec2 a = mesh.points()[star[k]], b = mesh.points()[star[(k + 1) % star.size()]];
      expected += 0.5 * (a.x * b.y - a.y * b.x);
    }
    mesh.find_inside();
    const auto inside = [&] {
      double sum = 0.0;
      for (const Triangle& t : mesh.triangles()) sum += t.inside ? area(mesh, t) : 0.0;
      return sum;
    };
    EXPECT_NEAR(inside(), expected, 1e-12);
    expect_sound(mesh, 4.0, true);
    // Each side of the star divided somewhere near it.
    for (std::size_t k = 0; k < star.size(); ++k) {
      const std::uint32_t from = star[k], to = star[(k + 1) % star.size()];
      const glm::dvec2 at =
          on_grid(glm::mix(mesh.points()[from], mesh.points()[to], random.between(0.2, 0.8)));
      const std::uint32_t point = mesh.divide_segment(from, to, at);
      ASSERT_EQ(point + 1, mesh.points().size());
      EXPECT_EQ(mesh.divide_segment(from, to, at), PlaneMesh::k_none);
    }
    EXPECT_NEAR(inside(), expected, 1e-9);
    expect_sound(mesh, 4.0, true);
  }
}

TEST(PlaneMesh, NumbersTheRegionsOutside) {
  PlaneMesh mesh({-2, -2}, {2, 2});
  const auto frame = [&](double size) {
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = mesh.add_point(size * glm::dvec2(k == 0 || k == 3 ? -1 : 1, k < 2 ? -1 : 1));
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_FALSE(mesh.add_segment(corners[k], corners[(k + 1) % 4], PlaneMesh::k_outline).has_value());
  };
  frame(1.0);
  frame(0.5);
  mesh.find_inside();
  ASSERT_EQ(mesh.region_count(), 2U);
  std::array<double, 2> areas{};
  for (const Triangle& t : mesh.triangles()) {
    if (!t.inside) areas[t.region] += area(mesh, t);
  }
  EXPECT_NEAR(areas[0], 12.0, 1e-12);
  EXPECT_NEAR(areas[1], 1.0, 1e-12);
}

TEST(PlaneMesh, TellsWhatIsInTheWay) {
  PlaneMesh mesh({-1, -1}, {1, 1});
  const auto a = mesh.add_point({-0.5, 0.0}), b = mesh.add_point({0.5, 0.0}), c = mesh.add_point({0.0, -0.5}),
             d = mesh.add_point({0.0, 0.5});
  EXPECT_FALSE(mesh.add_segment(a, b, PlaneMesh::k_outline).has_value());
  const auto crossed = mesh.add_segment(c, d, PlaneMesh::k_outline);
  ASSERT_TRUE(crossed.has_value());
  EXPECT_TRUE((crossed->segment == std::array{a, b}) || (crossed->segment == std::array{b, a}));
  const auto middle = mesh.add_point({0.0, 0.0});
  const auto passed = mesh.add_segment(c, d, PlaneMesh::k_outline);
  ASSERT_TRUE(passed.has_value());
  EXPECT_EQ(passed->point, middle);
}

TEST(PlaneMesh, SidesAreExact) {
  const double step = std::ldexp(1.0, -45);
  const glm::dvec2 a(-0.75, -0.5), b(0.75, 0.5);
  const glm::dvec2 on(0.375, 0.25);
  EXPECT_EQ(PlaneMesh::side_of(a, b, on), 0);
  EXPECT_EQ(PlaneMesh::side_of(a, b, on + glm::dvec2(0, step)), 1);
  EXPECT_EQ(PlaneMesh::side_of(a, b, on - glm::dvec2(0, step)), -1);
}

}  // namespace
}  // namespace moldlight
