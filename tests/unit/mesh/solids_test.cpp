// Bodies that enclose something, distinguished from open ones in the same mesh.
#include <algorithm>

#include <gtest/gtest.h>

#include "mesh/adjacency.hpp"
#include "mesh/weld.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

std::ptrdiff_t solid_count(const TriangleMesh& mesh) {
  const std::vector<bool> solid = solid_facets(mesh, build_adjacency(mesh));
  EXPECT_EQ(solid.size(), mesh.facets.size());
  return std::ranges::count(solid, true);
}

TEST(Solids, AreBodiesWithoutOpenEdges) {
  TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(solid_count(box), 12);
  TriangleMesh open = test::box_mesh({3, 0, 0}, {4, 1, 1});
  open.facets.pop_back();
  EXPECT_EQ(solid_count(open), 0);
  EXPECT_EQ(solid_count(test::joined(open, box)), 12) << "one of the two";
  box.facets.push_back({0, 0, 1});
  EXPECT_EQ(solid_count(test::joined(open, box)), 13) << "a collapsed facet opens nothing";
  test::reverse_facet(box, 3);
  EXPECT_EQ(solid_count(test::joined(open, box)), 1) << "wound both ways";
}

TEST(Solids, MayTouchAlongAnEdge) {
  std::vector<glm::dvec3> corners = test::box_corners({0, 0, 0}, {1, 1, 1});
  const std::vector<glm::dvec3> others = test::box_corners({1, 1, 0}, {2, 2, 1});
  corners.insert(corners.end(), others.begin(), others.end());
  const TriangleMesh mesh = weld_corners(corners);
  ASSERT_EQ(mesh.vertices.size(), 14U);
  EXPECT_EQ(solid_count(mesh), 24);
}

}  // namespace
}  // namespace moldlight
