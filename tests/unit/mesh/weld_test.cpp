#include "mesh/weld.hpp"

#include <random>

#include <gtest/gtest.h>

#include "support/boxes.hpp"

namespace moldlight {
namespace {

TEST(Weld, BoxHasEightVertices) {
  const auto corners = test::box_corners({0, 0, 0}, {1, 2, 3});
  const TriangleMesh mesh = weld_corners(corners);
  ASSERT_EQ(mesh.facets.size(), 12u);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  for (FacetIndex facet = 0; facet < 12; ++facet) {
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(mesh.corner(facet, corner), corners[3 * facet + static_cast<std::size_t>(corner)]);
    }
  }
}

TEST(Weld, NumbersVerticesInOrderOfFirstUse) {
  const TriangleMesh mesh = weld_corners(test::box_corners({0, 0, 0}, {1, 2, 3}));
  VertexIndex next = 0;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) {
      ASSERT_LE(vertex, next);
      if (vertex == next) ++next;
    }
  }
  EXPECT_EQ(next, mesh.vertices.size());
}

TEST(Weld, NegativeZeroIsZero) {
  const std::vector<glm::dvec3> corners = {{0.0, 0.0, 1.0}, {-0.0, 0.0, 1.0}, {0.0, -0.0, 1.0}};
  const TriangleMesh mesh = weld_corners(corners);
  ASSERT_EQ(mesh.vertices.size(), 1u);
  EXPECT_FALSE(std::signbit(mesh.vertices[0].x));
}

TEST(Weld, NearPointsStayApart) {
  const double next_up = std::nextafter(1.0, 2.0);
  const std::vector<glm::dvec3> corners = {{1.0, 0.0, 0.0}, {next_up, 0.0, 0.0}, {1.0, 1.0, 0.0}};
  EXPECT_EQ(weld_corners(corners).vertices.size(), 3u);
}

TEST(Weld, NothingWeldsToNothing) {
  const TriangleMesh mesh = weld_corners({});
  EXPECT_TRUE(mesh.vertices.empty());
  EXPECT_TRUE(mesh.facets.empty());
}

TEST(Weld, IndexedMeshLosesEqualAndUnusedVertices) {
  TriangleMesh mesh;
  mesh.vertices = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.facets = {{1, 2, 3}, {4, 6, 5}};
  const TriangleMesh welded = weld_vertices(mesh);
  EXPECT_EQ(welded.vertices.size(), 4u);
  ASSERT_EQ(welded.facets.size(), 2u);
  EXPECT_EQ(welded.facets[0], (std::array<VertexIndex, 3>{0, 1, 2}));
  EXPECT_EQ(welded.facets[1], (std::array<VertexIndex, 3>{1, 3, 2}));
}

TEST(Weld, ManyPointsOfAGridWeldExactly) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-20, 20);
  std::vector<glm::dvec3> corners;
  std::vector<bool> seen(41 * 41 * 41, false);
  std::size_t distinct = 0;
  for (int i = 0; i < 90'000; ++i) {
    const int x = coordinate(random), y = coordinate(random), z = coordinate(random);
    const auto place = static_cast<std::size_t>(((x + 20) * 41 + y + 20) * 41 + z + 20);
    distinct += seen[place] ? 0 : 1;
    seen[place] = true;
    corners.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
  }
  const TriangleMesh mesh = weld_corners(corners);
  EXPECT_EQ(mesh.vertices.size(), distinct);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ASSERT_EQ(mesh.vertices[mesh.facets[i / 3][i % 3]], corners[i]);
  }
}

}  // namespace
}  // namespace moldlight
