#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "classify/part_model.hpp"
#include "parting/make_halves.hpp"
#include "parting/part_sheets.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

constexpr std::uint32_t k_sides = 24;

/// Radius 1 below, `top` above, height 1; the points of its rings off by up to `rounding`.
TriangleMesh prism(double top, double rounding) {
  test::Random random(7);
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (std::uint32_t k = 0; k < k_sides; ++k) {
      const double turn = 2.0 * std::numbers::pi * k / k_sides, radius = z > 0.0 ? top : 1.0;
      mesh.vertices.emplace_back(radius * std::cos(turn) + random.between(-rounding, rounding),
                                 radius * std::sin(turn) + random.between(-rounding, rounding), z);
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, 1.0);
  for (std::uint32_t k = 0; k < k_sides; ++k) {
    const std::uint32_t a = k, b = (k + 1) % k_sides;
    mesh.facets.push_back({a, b, k_sides + b});
    mesh.facets.push_back({a, k_sides + b, k_sides + a});
    mesh.facets.push_back({b, a, 2 * k_sides});
    mesh.facets.push_back({k_sides + a, k_sides + b, 2 * k_sides + 1});
  }
  return mesh;
}

SheetFrame frame_of(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  return {mold_frame({0, 0, 1}), box.center(), glm::distance(box.min, box.max)};
}

TEST(UprightWalls, StandExactlyUprightAndHardlyMove) {
  const TriangleMesh mesh = prism(1.0, 2e-6);
  const auto upright = with_upright_walls(mesh, frame_of(mesh));
  ASSERT_TRUE(upright);
  ASSERT_EQ(upright->facets, mesh.facets);
  for (std::uint32_t k = 0; k < k_sides; ++k) {
    const glm::dvec3 &below = upright->vertices[k], &above = upright->vertices[k_sides + k];
    EXPECT_NEAR(below.x, above.x, 1e-14);
    EXPECT_NEAR(below.y, above.y, 1e-14);
  }
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    EXPECT_LT(glm::distance(mesh.vertices[k], upright->vertices[k]), 4e-6);
    EXPECT_EQ(mesh.vertices[k].z, upright->vertices[k].z);
  }
}

TEST(UprightWalls, WithDraftKeepIt) {
  const TriangleMesh drafted = prism(0.99, 0.0), upright = prism(1.0, 0.0);
  EXPECT_FALSE(with_upright_walls(drafted, frame_of(drafted)));
  EXPECT_FALSE(with_upright_walls(upright, frame_of(upright)));
}

TEST(UprightWalls, ThatLeanByRoundingGetASurfaceOfOnePlane) {
  Part part;
  part.mesh = prism(1.0, 2e-6);
  const auto model = prepare_part(std::move(part), Progress());
  const MoldHalves halves = make_halves(*model, {0, 0, 1}, {.height = 0.5, .line = nullptr}, {}, Progress());
  ASSERT_TRUE(halves.made()) << halves.refusal;
  EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-12);
  EXPECT_NEAR(halves.surface.rim_high, halves.surface.rim_low, 1e-9);
  EXPECT_EQ(halves.surface.faces, 1U);
  EXPECT_EQ(halves.contact_area, 0.0);
  EXPECT_NE(halves.upright_volume, 0.0);
  EXPECT_NEAR(halves.upright_volume / halves.part_volume, 0.0, 1e-5);
}

}  // namespace
}  // namespace moldlight
