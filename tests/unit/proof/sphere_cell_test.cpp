// Cells must tile the half-sphere, and their caps hold them.
#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"
#include "proof/certain_undercut.hpp"
#include "support/proof_model.hpp"

namespace moldlight {
namespace {

std::vector<SphereCell> cells_of_generation(int generation) {
  const auto octants = half_sphere_cells();
  std::vector<SphereCell> cells(octants.begin(), octants.end());
  for (int k = 0; k < generation; ++k) {
    std::vector<SphereCell> quartered;
    for (const SphereCell& cell : cells) {
      for (const SphereCell& quarter : cell.quarters()) quartered.push_back(quarter);
    }
    cells = std::move(quartered);
  }
  return cells;
}

TEST(SphereCell, TilesTheHalfSphere) {
  const std::vector<SphereCell> cells = cells_of_generation(4);
  double share = 0.0;
  for (const SphereCell& cell : cells) share += cell.share();
  EXPECT_NEAR(share, 1.0, 1e-12);
  test::Random random(3);
  for (int k = 0; k < 500; ++k) {
    const glm::dvec3 direction = half_sphere(glm::normalize(random.in_cube(1.0)));
    const auto within =
        std::ranges::count_if(cells, [&](const SphereCell& cell) { return cell.contains(direction); });
    EXPECT_EQ(within, 1) << direction.x << ' ' << direction.y << ' ' << direction.z;
  }
}

TEST(SphereCell, LiesInItsCap) {
  test::Random random(4);
  for (const int generation : {0, 3, 6}) {
    for (const SphereCell& cell : cells_of_generation(generation)) {
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 direction = test::random_direction(cell, random);
        ASSERT_TRUE(cell.contains(direction));
        ASSERT_LE(line_angle_deg(direction, cell.centre()), cell.radius_deg());
      }
      for (const glm::dvec3& corner : cell.corners())
        ASSERT_LE(line_angle_deg(corner, cell.centre()), cell.radius_deg());
    }
  }
}

TEST(SphereCell, HalvesItsRadiusWithEachGeneration) {
  double widest = 0.0;
  for (const SphereCell& cell : cells_of_generation(7)) widest = std::max(widest, cell.radius_deg());
  EXPECT_LT(widest, 0.7);
}

}  // namespace
}  // namespace moldlight
