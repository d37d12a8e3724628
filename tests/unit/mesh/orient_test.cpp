#include "mesh/orient.hpp"

#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "mesh/weld.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

TriangleMesh reversed(TriangleMesh mesh) {
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) test::reverse_facet(mesh, facet);
  return mesh;
}

TriangleMesh cube(double low, double high) { return test::box_mesh(glm::dvec3(low), glm::dvec3(high)); }

/// What turning must make of `mesh`; also checks that a second call finds nothing left to do.
void expect_turned_into(TriangleMesh mesh, const TriangleMesh& expected, std::size_t components) {
  const TurnedFacets turned = turn_if_inside_out(mesh);
  EXPECT_EQ(turned.components, components);
  EXPECT_EQ(turned.facets, 12 * components);
  EXPECT_EQ(turned_warning(turned).empty(), components == 0);
  EXPECT_EQ(mesh.facets, expected.facets);
  EXPECT_EQ(turn_if_inside_out(mesh).facets, 0u);
}

TEST(Orient, OutwardPartStays) { expect_turned_into(cube(0, 1), cube(0, 1), 0); }

TEST(Orient, InsideOutPartIsTurned) {
  expect_turned_into(reversed(cube(0, 1)), cube(0, 1), 1);
  TriangleMesh mesh = reversed(cube(0, 1));
  EXPECT_EQ(turned_warning(turn_if_inside_out(mesh)),
            "The part was inside out: all its 12 facets were turned.");
}

TEST(Orient, VoidStays) {
  const TriangleMesh hollow = test::joined(cube(0, 10), reversed(cube(3, 5)));
  expect_turned_into(hollow, hollow, 0);
}

TEST(Orient, HollowPartInsideOutIsTurnedAsAWhole) {
  const TriangleMesh hollow = test::joined(cube(0, 10), reversed(cube(3, 5)));
  expect_turned_into(reversed(hollow), hollow, 2);
}

TEST(Orient, OnlyTheInsideOutBodyIsTurned) {
  const TriangleMesh both = test::joined(cube(0, 1), cube(5, 9));
  expect_turned_into(test::joined(cube(0, 1), reversed(cube(5, 9))), both, 1);
  expect_turned_into(test::joined(reversed(cube(0, 1)), cube(5, 9)), both, 1);
}

TEST(Orient, BodyInsideAVoidIsTurned) {
  const TriangleMesh hollow = test::joined(cube(0, 10), reversed(cube(2, 8)));
  expect_turned_into(test::joined(hollow, reversed(cube(4, 6))), test::joined(hollow, cube(4, 6)), 1);
}

TEST(Orient, OverlappingBodiesStay) {
  const TriangleMesh overlapping = test::joined(cube(0, 10), cube(2, 8));
  expect_turned_into(overlapping, overlapping, 0);
  const TriangleMesh with_void = test::joined(overlapping, reversed(cube(4, 6)));
  expect_turned_into(with_void, with_void, 0);
}

TEST(Orient, BoxInsideANotchIsNoVoid) {
  // Two legs and a bar: the box of this U encloses the cube, the U does not.
  TriangleMesh u =
      test::joined(test::box_mesh({0, 0, 0}, {10, 2, 10}), test::box_mesh({0, 8, 0}, {10, 10, 10}));
  u = test::joined(u, test::box_mesh({0, 2, 0}, {10, 8, 2}));
  u = weld_vertices(u);
  const TriangleMesh inner = test::box_mesh({4, 4, 4}, {6, 6, 6});
  expect_turned_into(test::joined(u, reversed(inner)), test::joined(u, inner), 1);
}

TEST(Orient, NearlyClosedPartIsTurned) {
  TriangleMesh grid = cube(0, 1);
  for (int round = 0; round < 3; ++round) {
    TriangleMesh finer;
    for (FacetIndex facet = 0; facet < grid.facets.size(); ++facet) {
      const auto first = static_cast<VertexIndex>(finer.vertices.size());
      for (int corner = 0; corner < 3; ++corner) finer.vertices.push_back(grid.corner(facet, corner));
      for (int corner = 0; corner < 3; ++corner) {
        finer.vertices.push_back(0.5 * (grid.corner(facet, corner) + grid.corner(facet, (corner + 1) % 3)));
      }
      finer.facets.push_back({first, first + 3, first + 5});
      finer.facets.push_back({first + 3, first + 1, first + 4});
      finer.facets.push_back({first + 5, first + 4, first + 2});
      finer.facets.push_back({first + 3, first + 4, first + 5});
    }
    grid = weld_vertices(finer);
  }
  grid = reversed(grid);
  grid.facets.pop_back();
  EXPECT_EQ(turn_if_inside_out(grid).facets, grid.facets.size());
}

TEST(Orient, SurfaceWithoutThicknessStays) {
  TriangleMesh open = cube(0, 1);
  open.facets.resize(6);
  const TriangleMesh before = reversed(open);
  TriangleMesh after = before;
  EXPECT_EQ(turn_if_inside_out(after).facets, 0u);
  EXPECT_EQ(after.facets, before.facets);
}

TEST(Orient, InconsistentWindingStays) {
  TriangleMesh mesh = reversed(cube(0, 1));
  test::reverse_facet(mesh, 0);
  const auto before = mesh.facets;
  EXPECT_EQ(turn_if_inside_out(mesh).facets, 0u);
  EXPECT_EQ(mesh.facets, before);
}

}  // namespace
}  // namespace moldlight
