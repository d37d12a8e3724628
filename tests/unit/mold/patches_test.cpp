// Undercut patches: what counts as part of one, what connects and what is too small.
#include "mold/patches.hpp"

#include <gtest/gtest.h>

#include "mesh/adjacency.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

constexpr auto k_undercut = static_cast<std::size_t>(Region::undercut);

/// Patches of a cube of side 10, two facets a side, whose facets have these undercut fractions.
UndercutPatches patches_of_cube(const std::array<double, 12>& fractions) {
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
  FacetFractions facets(mesh.facets.size());
  for (std::size_t facet = 0; facet < facets.size(); ++facet) facets[facet][k_undercut] = fractions.at(facet);
  return undercut_patches(facets, facet_geometry(mesh), build_adjacency(mesh));
}

TEST(UndercutPatches, NoneWhereNothingIsUndercut) {
  const UndercutPatches patches = patches_of_cube({});
  EXPECT_EQ(patches.count, 0u);
  EXPECT_EQ(patches.of_facet, std::vector<FacetIndex>(12, k_no_facet));
}

TEST(UndercutPatches, AllFacetsOfAClosedPartConnect) {
  std::array<double, 12> all{};
  all.fill(1.0);
  const UndercutPatches patches = patches_of_cube(all);
  EXPECT_EQ(patches.count, 1u);
  EXPECT_DOUBLE_EQ(patches.areas.at(0), 600.0);
}

TEST(UndercutPatches, ALargeFacetCountsByItsUndercutArea) {
  std::array<double, 12> one{};
  one[3] = 0.1;  // 5 of 600: little of the facet, but nothing that one overlooks
  const UndercutPatches patches = patches_of_cube(one);
  ASSERT_EQ(patches.count, 1u);
  EXPECT_NEAR(patches.areas[0], 5.0, 1e-6);
  EXPECT_EQ(patches.of_facet[3], 0u);
  one[3] = 0.01;  // 0.5 of 600: a thin border
  EXPECT_EQ(patches_of_cube(one).count, 0u);
}

TEST(UndercutPatches, OppositeSidesAreTwoAndTheLargerComesFirst) {
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
  const FacetGeometry geometry = facet_geometry(mesh);
  std::array<double, 12> two{};
  for (std::size_t facet = 0; facet < 12; ++facet) {
    if (geometry.normals[facet].z > 0.5) two.at(facet) = 0.6;
    if (geometry.normals[facet].z < -0.5) two.at(facet) = 0.9;
  }
  const UndercutPatches patches = patches_of_cube(two);
  ASSERT_EQ(patches.count, 2u);
  EXPECT_NEAR(patches.areas[0], 90.0, 1e-4);
  EXPECT_NEAR(patches.areas[1], 60.0, 1e-4);
  for (std::size_t facet = 0; facet < 12; ++facet) {
    const FacetIndex patch = patches.of_facet[facet];
    const double up = geometry.normals[facet].z;
    EXPECT_EQ(patch, up < -0.5 ? 0u : up > 0.5 ? 1u : k_no_facet) << facet;
  }
}

}  // namespace
}  // namespace moldlight
