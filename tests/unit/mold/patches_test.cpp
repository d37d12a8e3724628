// Undercut undercuts: what counts as part of one, what connects and what is too small.
#include <gtest/gtest.h>

#include "mesh/adjacency.hpp"
#include "mold/area_error.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

constexpr auto k_undercut = static_cast<std::size_t>(Region::undercut);

/// Undercuts of a cube of side 10, two facets a side, whose facets have these undercut fractions.
FacetUndercuts patches_of_cube(const std::array<double, 12>& fractions) {
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
  FacetFractions facets(mesh.facets.size());
  for (std::size_t facet = 0; facet < facets.size(); ++facet) facets[facet][k_undercut] = fractions.at(facet);
  return facet_undercuts(facets, facet_geometry(mesh), build_adjacency(mesh));
}

TEST(FacetUndercuts, NoneWhereNothingIsUndercut) {
  const FacetUndercuts undercuts = patches_of_cube({});
  EXPECT_EQ(undercuts.count, 0u);
  EXPECT_EQ(undercuts.of_facet, std::vector<FacetIndex>(12, k_no_facet));
}

TEST(FacetUndercuts, AllFacetsOfAClosedPartConnect) {
  std::array<double, 12> all{};
  all.fill(1.0);
  const FacetUndercuts undercuts = patches_of_cube(all);
  EXPECT_EQ(undercuts.count, 1u);
  EXPECT_DOUBLE_EQ(undercuts.areas.at(0), 600.0);
}

TEST(FacetUndercuts, ALargeFacetCountsByItsUndercutArea) {
  std::array<double, 12> one{};
  one[3] = 0.1;  // 5 of 600: little of the facet, but nothing that one overlooks
  const FacetUndercuts undercuts = patches_of_cube(one);
  ASSERT_EQ(undercuts.count, 1u);
  EXPECT_NEAR(undercuts.areas[0], 5.0, 1e-6);
  EXPECT_EQ(undercuts.of_facet[3], 0u);
  one[3] = 0.01;  // 0.5 of 600: a thin border
  EXPECT_EQ(patches_of_cube(one).count, 0u);
}

TEST(FacetUndercuts, OppositeSidesAreTwoAndTheLargerComesFirst) {
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
  const FacetGeometry geometry = facet_geometry(mesh);
  std::array<double, 12> two{};
  for (std::size_t facet = 0; facet < 12; ++facet) {
    if (geometry.normals[facet].z > 0.5) two.at(facet) = 0.6;
    if (geometry.normals[facet].z < -0.5) two.at(facet) = 0.9;
  }
  const FacetUndercuts undercuts = patches_of_cube(two);
  ASSERT_EQ(undercuts.count, 2u);
  EXPECT_NEAR(undercuts.areas[0], 90.0, 1e-4);
  EXPECT_NEAR(undercuts.areas[1], 60.0, 1e-4);
  for (std::size_t facet = 0; facet < 12; ++facet) {
    const FacetIndex undercut = undercuts.of_facet[facet];
    const double up = geometry.normals[facet].z;
    EXPECT_EQ(undercut, up < -0.5 ? 0u : up > 0.5 ? 1u : k_no_facet) << facet;
  }
}

}  // namespace
}  // namespace moldlight
