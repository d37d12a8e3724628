#include "mesh/repair.hpp"

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/weld.hpp"

namespace moldlight {
namespace {

/// The cube [0, 10]^3, wound outwards.
Part cube() {
  Part part;
  for (int i = 0; i < 8; ++i) part.mesh.vertices.emplace_back(i & 1 ? 10 : 0, i & 2 ? 10 : 0, i & 4 ? 10 : 0);
  part.mesh.facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  part.bodies = {{"cube", 0, 12}};
  return part;
}

HealthReport health_of(const Part& part) { return health_report(part.mesh, facet_geometry(part.mesh)); }

Part repaired(Part part, RepairLevel level = RepairLevel::full, double tolerance = 0.0) {
  repair_part(part, {.level = level, .weld_tolerance = tolerance});
  return part;
}

void expect_whole_cube(const Part& part) {
  const HealthReport health = health_of(part);
  EXPECT_TRUE(health.closed);
  EXPECT_EQ(health.open_edges, 0u);
  EXPECT_EQ(health.degenerate_facets, 0u);
  EXPECT_EQ(health.duplicate_facets, 0u);
  EXPECT_NEAR(health.volume, 1000.0, 1e-3);
  EXPECT_NEAR(health.area, 600.0, 1e-3);
}

TEST(Repair, LeavesAWholePartAsItIs) {
  const Part part = repaired(cube());
  EXPECT_EQ(part.mesh.facets, weld_vertices(cube().mesh).facets);
  EXPECT_EQ(part.mesh.vertices.size(), 8u);
  EXPECT_EQ(part.repairs, std::vector<std::string>{"nothing to repair"});
  Part untouched = cube();
  repair_part(untouched, {});
  EXPECT_TRUE(untouched.repairs.empty());
}

TEST(Repair, WeldsCracksWithinTheToleranceOnly) {
  // Every facet has corners of its own, each a little off.
  Part part = cube();
  Part soup;
  soup.bodies = part.bodies;
  for (FacetIndex facet = 0; facet < 12; ++facet) {
    for (int corner = 0; corner < 3; ++corner) {
      const double off = 1e-6 * ((3 * facet + static_cast<unsigned>(corner)) % 5);
      soup.mesh.vertices.push_back(part.mesh.corner(facet, corner) + glm::dvec3(off, -off, off));
    }
    soup.mesh.facets.push_back({3 * facet, 3 * facet + 1, 3 * facet + 2});
  }
  const Part welded = repaired(soup, RepairLevel::weld, 1e-5);
  expect_whole_cube(welded);
  EXPECT_TRUE(welded.file_facets.empty());
  EXPECT_EQ(welded.mesh.vertices.size(), 8u);
  EXPECT_EQ(welded.repairs[0], "28 vertices of open edges welded within 0.00001");
  EXPECT_EQ(welded.repairs[1], "36 open edges before, 0 after");
  EXPECT_GT(health_of(repaired(soup, RepairLevel::weld, 1e-9)).open_edges, 0u);
}

TEST(Repair, WeldsNothingInsideTheSurface) {
  // A pyramid's worth of small facets in the middle of a face, far smaller than the tolerance.
  Part part = cube();
  const VertexIndex first = 8;
  for (int i = 0; i < 3; ++i)
    part.mesh.vertices.push_back(glm::dvec3(6, 4, 0) + 1e-7 * glm::dvec3(i == 0, i == 1, 0));
  part.mesh.facets[0] = {0, 2, 3};
  part.mesh.facets[1] = {0, first, 1};
  for (const auto& facet : {std::array<VertexIndex, 3>{first, first + 1, 1},
                            {first + 1, 3, 1},
                            {0, 3, first + 2},
                            {0, first + 2, first},
                            {first + 2, 3, first + 1},
                            {first, first + 2, first + 1}}) {
    part.mesh.facets.push_back(facet);
  }
  part.bodies[0].facet_count = 18;
  ASSERT_EQ(health_of(part).open_edges, 0u);
  EXPECT_EQ(repaired(part, RepairLevel::weld, 0.01).mesh.vertices.size(), 11u);
}

TEST(Repair, DropsDuplicatesAndCollapsedFacets) {
  Part part = cube();
  part.mesh.facets.insert(part.mesh.facets.begin() + 3,
                          {part.mesh.facets[5][1], part.mesh.facets[5][2], part.mesh.facets[5][0]});
  part.mesh.facets.push_back({1, 1, 2});
  part.mesh.facets.push_back({0, 3, 5});  // a membrane inside: one facet each way
  part.mesh.facets.push_back({3, 0, 5});
  part.bodies[0].facet_count = 16;
  const Part whole = repaired(part);
  expect_whole_cube(whole);
  EXPECT_EQ(whole.file_facets, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(whole.repairs[0], "1 facets with two equal corners dropped");
  EXPECT_EQ(whole.repairs[1], "3 duplicate facets dropped");
}

TEST(Repair, MergesFacetsWithoutAreaIntoTheirNeighbours) {
  // The edge from 0 to 3 is cut at its middle on one side only, and a facet without area lies between.
  Part part = cube();
  part.mesh.vertices.emplace_back(5, 5, 0);
  part.mesh.facets[0] = {0, 2, 8};
  part.mesh.facets.push_back({8, 2, 3});
  part.mesh.facets.push_back({0, 8, 3});
  part.bodies[0].facet_count = 14;
  part.facet_source.assign(14, 7);
  part.facet_source[1] = 9;
  ASSERT_TRUE(health_of(part).closed);
  const Part whole = repaired(part);
  expect_whole_cube(whole);
  EXPECT_EQ(whole.mesh.facets.size(), 14u);
  EXPECT_EQ(whole.file_facets[13], 1u);
  EXPECT_EQ(whole.facet_source[13], 9u);
  EXPECT_EQ(whole.facet_source[12], 7u);
}

TEST(Repair, MakesTheWindingConsistent) {
  Part part = cube();
  for (const std::size_t facet : {1u, 2u, 7u, 10u})
    std::swap(part.mesh.facets[facet][1], part.mesh.facets[facet][2]);
  ASSERT_FALSE(health_of(part).closed);
  const Part whole = repaired(part);
  expect_whole_cube(whole);
  EXPECT_EQ(whole.mesh.facets, weld_vertices(cube().mesh).facets);
  EXPECT_EQ(whole.repairs[0], "4 facets turned for consistent winding");
}

TEST(Repair, FillsHolesOfTheirBody) {
  Part part = cube();
  Part second = cube();
  for (auto& facet : second.mesh.facets) {
    for (VertexIndex& corner : facet) corner += 8;
  }
  for (glm::dvec3& vertex : second.mesh.vertices) part.mesh.vertices.push_back(vertex + glm::dvec3(20, 0, 0));
  part.mesh.facets.pop_back();
  part.mesh.facets.insert(part.mesh.facets.end(), second.mesh.facets.begin(), second.mesh.facets.end());
  part.bodies = {{"a", 0, 11}, {"b", 11, 12}};
  repair_part(part, {.level = RepairLevel::full, .largest_hole = 1.0});
  EXPECT_TRUE(health_of(part).closed);
  EXPECT_NEAR(health_of(part).volume, 2000.0, 1e-9);
  ASSERT_EQ(part.bodies.size(), 2u);
  EXPECT_EQ(part.bodies[0].facet_count, 12u);
  EXPECT_EQ(part.bodies[1].first_facet, 12u);
  EXPECT_EQ(part.file_facets[11], k_no_facet);
  EXPECT_EQ(part.file_facets[12], 11u);
  EXPECT_EQ(part.repairs[0], "1 holes filled with 1 facets of 50 in all");
}

TEST(Repair, FillsConcaveHolesAndLeavesLargeOnes) {
  // The cube without its upper face, once with a far larger box around for scale.
  Part part = cube();
  part.mesh.facets.erase(part.mesh.facets.begin() + 2, part.mesh.facets.begin() + 4);
  part.bodies[0].facet_count = 10;
  EXPECT_EQ(health_of(repaired(part)).open_edges, 4u);
  Part wide = part;
  repair_part(wide, {.level = RepairLevel::full, .largest_hole = 1.0});
  expect_whole_cube(wide);
}

TEST(Repair, ClosesCracksWhereNeighboursMeetInEdgesOfDifferentLength) {
  Part part = cube();
  part.mesh.vertices.emplace_back(5, 5, 0);
  part.mesh.facets[0] = {0, 2, 8};
  part.mesh.facets.push_back({8, 2, 3});
  part.bodies[0].facet_count = 13;
  ASSERT_EQ(health_of(part).open_edges, 3u);
  expect_whole_cube(repaired(part));
}

}  // namespace
}  // namespace moldlight
