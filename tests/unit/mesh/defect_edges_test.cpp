#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "mesh/weld.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

/// A flat sheet of width x height unit squares, of two facets each; `has_square` says which are there.
template <typename Filter>
TriangleMesh sheet(int width, int height, const Filter& has_square) {
  std::vector<glm::dvec3> corners;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!has_square(x, y)) continue;
      const glm::dvec3 a(x, y, 0), b(x + 1, y, 0), c(x + 1, y + 1, 0), d(x, y + 1, 0);
      corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  }
  return weld_corners(corners);
}

TEST(DefectChains, AreNoneInAClosedPart) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
  for (const EdgeDefect defect : {EdgeDefect::open, EdgeDefect::nonmanifold, EdgeDefect::inconsistent}) {
    EXPECT_TRUE(defect_chains(box, defect).empty());
  }
  EXPECT_TRUE(defect_chains(TriangleMesh{}, EdgeDefect::open).empty());
}

TEST(DefectChains, GiveTheRimOfAHole) {
  TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
  box.facets.erase(box.facets.begin() + 5);
  const auto chains = defect_chains(box, EdgeDefect::open);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[0].edge_count(), 3u);
}

TEST(DefectChains, AreOrderedByLengthAndMeasured) {
  const TriangleMesh ring = sheet(5, 5, [](int x, int y) { return x != 2 || y != 3; });
  const auto chains = defect_chains(ring, EdgeDefect::open);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_DOUBLE_EQ(chains[0].length, 20.0);
  EXPECT_EQ(chains[0].edge_count(), 20u);
  EXPECT_DOUBLE_EQ(chains[1].length, 4.0);
  EXPECT_EQ(chains[1].edge_count(), 4u);
  EXPECT_EQ(chains[1].bounds.min, glm::dvec3(2, 3, 0));
  EXPECT_EQ(chains[1].bounds.max, glm::dvec3(3, 4, 0));
  EXPECT_EQ(chains[0].facet, 0u);
}

TEST(DefectChains, AreToldApartWhereHolesTouch) {
  const TriangleMesh sieve = sheet(6, 6, [](int x, int y) { return !(x == y && x >= 1 && x <= 4); });
  const auto chains = defect_chains(sieve, EdgeDefect::open);
  ASSERT_EQ(chains.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_TRUE(chains[i].closed);
    EXPECT_EQ(chains[i].edge_count(), 4u);
  }
  EXPECT_DOUBLE_EQ(chains[0].length, 24.0);
}

TEST(DefectChains, EndWhereTheDefectEnds) {
  // Three sheets that meet along a line of three edges.
  std::vector<glm::dvec3> corners;
  for (const glm::dvec3& side : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 1), glm::dvec3(0, -1, -1)}) {
    for (int x = 0; x < 3; ++x) {
      corners.insert(corners.end(),
                     {glm::dvec3(x, 0, 0), glm::dvec3(x + 1, 0, 0), glm::dvec3(x, 0, 0) + side});
    }
  }
  const TriangleMesh fin = weld_corners(corners);
  const auto chains = defect_chains(fin, EdgeDefect::nonmanifold);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_FALSE(chains[0].closed);
  EXPECT_EQ(chains[0].edge_count(), 3u);
  EXPECT_DOUBLE_EQ(chains[0].length, 3.0);
}

TEST(DefectChains, SurroundAFlippedFacet) {
  TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
  test::reverse_facet(box, 7);
  const auto chains = defect_chains(box, EdgeDefect::inconsistent);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[0].edge_count(), 3u);
}

TEST(DefectChains, AHubOfManySpokesTakesLinearTime) {
  std::vector<glm::dvec3> corners;
  constexpr int k_leaves = 100'000;
  for (int i = 0; i < k_leaves; ++i) {
    corners.insert(corners.end(), {glm::dvec3(0), glm::dvec3(i, 1, 0), glm::dvec3(i, 2, 1)});
  }
  const auto chains = defect_chains(weld_corners(corners), EdgeDefect::open);
  ASSERT_EQ(chains.size(), static_cast<std::size_t>(k_leaves));
  for (const EdgeChain& chain : chains) ASSERT_EQ(chain.edge_count(), 3u);
}

}  // namespace
}  // namespace moldlight
