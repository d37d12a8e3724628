#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "classify/part_model.hpp"
#include "parting/make_halves.hpp"
#include "parting/planar_line.hpp"
#include "support/classify_mesh.hpp"

namespace moldlight {
namespace {

constexpr std::uint32_t k_twisted = 60;

/// Radius 1, height 1. The corners of the upper ring stand above the middles of the lower one's sides, so
/// that every other facet of the wall leans back from either half by 0.0014.
TriangleMesh twisted_prism() {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (std::uint32_t k = 0; k < k_twisted; ++k) {
      const double turn = 2.0 * std::numbers::pi * (k + 0.5 * z) / k_twisted;
      mesh.vertices.emplace_back(std::cos(turn), std::sin(turn), z);
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, 1.0);
  for (std::uint32_t k = 0; k < k_twisted; ++k) {
    const std::uint32_t a = k, b = (k + 1) % k_twisted;
    mesh.facets.push_back({a, b, k_twisted + a});
    mesh.facets.push_back({b, k_twisted + b, k_twisted + a});
    mesh.facets.push_back({b, a, 2 * k_twisted});
    mesh.facets.push_back({k_twisted + a, k_twisted + b, 2 * k_twisted + 1});
  }
  return mesh;
}

TEST(WallCaps, LetHalvesMeetInOnePlaneWhereFacetsLeanBothWays) {
  const auto model = test::model_of(twisted_prism());
  const glm::dvec3 up(0, 0, 1);
  const MoldLine line = find_mold_line(*model, {up, {}}, {}, Progress{});
  ASSERT_LT(line.line.outer_high - line.line.outer_low, 1e-9);

  const MoldHalves plain =
      make_halves(*model, up, {.height = line.assignment.height, .line = &line.line}, {}, Progress{});
  ASSERT_TRUE(plain.made()) << plain.refusal;
  EXPECT_LT(plain.surface.shelf_share(), 0.99);

  const MoldHalves halves = make_halves(*model, up, meeting_place(line), {}, Progress{});
  ASSERT_TRUE(halves.certified()) << halves.refusal;
  EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-12);
  EXPECT_EQ(halves.surface.faces, 1U);
  // Between the part and the prism over both rings' outlines together.
  const double turn = std::numbers::pi / k_twisted;
  const double most = std::numbers::pi - 0.5 * k_twisted * std::sin(2.0 * turn);
  EXPECT_GT(halves.upright_volume, 0.0);
  EXPECT_LT(halves.upright_volume, most);
}

TEST(WallCaps, LeaveWallsThatLeanByMoreThanTwiceTheLateralTolerance) {
  TriangleMesh mesh = twisted_prism();
  for (std::uint32_t k = 0; k < k_twisted; ++k) {
    mesh.vertices[k_twisted + k].x *= 1.004;
    mesh.vertices[k_twisted + k].y *= 1.004;
  }
  const auto model = test::model_of(mesh);
  const glm::dvec3 up(0, 0, 1);
  const MoldLine line = find_mold_line(*model, {up, {}}, {}, Progress{});
  const MoldHalves halves = make_halves(*model, up, meeting_place(line), {}, Progress{});
  ASSERT_TRUE(halves.made()) << halves.refusal;
  EXPECT_NEAR(halves.upright_volume, 0.0, 1e-6);
}

}  // namespace
}  // namespace moldlight
