// What rounding leaves in solids, and what is left of it.
#include "parting/halves/tidy_solid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "mesh/orient.hpp"
#include "support/boxes.hpp"
#include "support/mesh_edits.hpp"

namespace moldlight {
namespace {

std::size_t edges_of_other_than_two(const TriangleMesh& mesh) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> uses;
  for (const auto& facet : mesh.facets) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(facet[k], facet[(k + 1) % 3])];
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(uses, [](const auto& use) { return use.second != 2; }));
}

double least_height(const TriangleMesh& mesh) {
  double least = INFINITY;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(mesh.corner(facet, k), mesh.corner(facet, (k + 1) % 3)));
    const glm::dvec3 normal = glm::cross(mesh.corner(facet, 1) - mesh.corner(facet, 0),
                                         mesh.corner(facet, 2) - mesh.corner(facet, 0));
    least = std::min(least, glm::length(normal) / longest);
  }
  return least;
}

/// Makes equal vertices one; how many are used.
std::size_t weld_equal(TriangleMesh& mesh) {
  std::set<VertexIndex> used;
  for (auto& facet : mesh.facets) {
    for (VertexIndex& corner : facet) {
      const auto first = std::ranges::find(mesh.vertices, mesh.vertices[corner]);
      corner = static_cast<VertexIndex>(first - mesh.vertices.begin());
      used.insert(corner);
    }
  }
  return used.size();
}

/// A box whose top has a point almost on the edge between its two facets, joined to three corners.
TEST(TidySolid, TakesNeedlesOutOfFlatSurface) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {4, 4, 1});
  // The top's facets, and the diagonal between them.
  std::vector<FacetIndex> top;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    bool level = true;
    for (int k = 0; k < 3; ++k) level = level && mesh.corner(facet, k).z == 1.0;
    if (level) top.push_back(facet);
  }
  ASSERT_EQ(top.size(), 2U);
  const auto one = mesh.facets[top[0]];
  const glm::dvec3 middle = 0.5 * (mesh.vertices[one[0]] + mesh.vertices[one[1]]),
                   far = mesh.vertices[one[2]];
  const auto point = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.push_back(middle + 1e-6 * (far - middle));
  mesh.facets[top[0]] = {one[0], one[1], point};
  mesh.facets.push_back({one[1], one[2], point});
  mesh.facets.push_back({one[2], one[0], point});
  const bool needle = least_height(mesh) < 1e-5;
  ASSERT_TRUE(needle);
  tidy_solid(mesh, {.tolerance = 1e-7, .pull = {0, 0, -1}});
  EXPECT_EQ(mesh.facets.size(), 14U);
  EXPECT_EQ(edges_of_other_than_two(mesh), 0U);
  EXPECT_NEAR(signed_volume(mesh), 16.0, 1e-12);
  // Where the box ends under the needle, nothing can be flipped.
  const bool on_rim = middle.x == 0.0 || middle.x == 4.0 || middle.y == 0.0 || middle.y == 4.0;
  EXPECT_EQ(least_height(mesh) > 0.5, !on_rim);
}

double leaning_area(const TriangleMesh& mesh, const glm::dvec3& pull) {
  double area = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 normal = glm::cross(mesh.corner(facet, 1) - mesh.corner(facet, 0),
                                         mesh.corner(facet, 2) - mesh.corner(facet, 0));
    const double size = glm::length(normal), along = glm::dot(normal, pull);
    if (along > k_leaning_sine * size && along < 0.5 * size) area += 0.5 * size;
  }
  return area;
}

/// Two points of a wall lie so near each other that the last digit of one makes the facets between them lean.
TEST(TidySolid, TakesOutThinFacetsThatLeanByRounding) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {4, 4, 1});
  const auto insert = [&](FacetIndex facet, const glm::dvec3& at) {
    const auto corners = mesh.facets[facet];
    const auto point = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.push_back(at);
    mesh.facets[facet] = {corners[0], corners[1], point};
    mesh.facets.push_back({corners[1], corners[2], point});
    mesh.facets.push_back({corners[2], corners[0], point});
  };
  FacetIndex wall = 0;
  const auto on_wall = [&](int k) { return mesh.corner(wall, k).y == 0.0; };
  while (!(on_wall(0) && on_wall(1) && on_wall(2))) ++wall;
  const glm::dvec3 middle = (mesh.corner(wall, 0) + mesh.corner(wall, 1) + mesh.corner(wall, 2)) / 3.0;
  insert(wall, middle);
  // Of the three facets that which is above the point.
  const glm::dvec3 above = middle + glm::dvec3(0.0, 1e-6, 1e-3);
  const auto holds = [&](FacetIndex facet) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 &a = mesh.corner(facet, k), &b = mesh.corner(facet, (k + 1) % 3);
      if (glm::cross(b - a, above - a).y > 0.0) return false;
    }
    return true;
  };
  const auto last = static_cast<FacetIndex>(mesh.facets.size() - 1);
  const FacetIndex within = holds(wall) ? wall : holds(last - 1) ? last - 1 : last;
  insert(within, above);
  const glm::dvec3 pull(0, 0, 1);
  ASSERT_GT(leaning_area(mesh, pull), 0.0);
  TriangleMesh free = mesh;
  tidy_solid(free, {.tolerance = 2e-6});
  EXPECT_GT(leaning_area(free, pull), 0.0) << "nothing leans where nothing is pulled";
  tidy_solid(mesh, {.tolerance = 2e-6, .pull = pull});
  EXPECT_EQ(leaning_area(mesh, pull), 0.0);
  EXPECT_EQ(edges_of_other_than_two(mesh), 0U);
  EXPECT_NEAR(signed_volume(mesh), 16.0, 1e-5);
}

TEST(TidySolid, LeavesWhatIsBent) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {4, 2, 1e-3});
  const TriangleMesh before = mesh;
  tidy_solid(mesh, {.tolerance = 1e-7});
  EXPECT_NEAR(signed_volume(mesh), 8e-3, 1e-15);
  EXPECT_EQ(mesh.facets.size(), before.facets.size());
  EXPECT_EQ(edges_of_other_than_two(mesh), 0U);
}

TEST(TidySolid, DropsFinsWithoutThickness) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  const auto tip = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.emplace_back(3, 3, 3);
  const auto edge = mesh.facets[0];
  mesh.facets.push_back({edge[0], edge[1], tip});
  mesh.facets.push_back({edge[1], edge[0], tip});
  tidy_solid(mesh, {});
  EXPECT_EQ(mesh.facets.size(), 12U);
  EXPECT_EQ(edges_of_other_than_two(mesh), 0U);
}

/// Two boxes that touch in an edge, once as two solids and once with the void between them.
TEST(SplitTouching, PartsSolidsThatMeetInAnEdge) {
  for (const bool turned : {false, true}) {
    TriangleMesh mesh =
        test::joined(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::box_mesh({1, 1, 0}, {2, 2, 1}));
    weld_equal(mesh);
    if (turned) {
      for (auto& facet : mesh.facets) std::swap(facet[0], facet[1]);
    }
    ASSERT_EQ(edges_of_other_than_two(mesh), 1U);
    EXPECT_EQ(split_touching(mesh), 1U);
    EXPECT_EQ(edges_of_other_than_two(mesh), 0U);
    EXPECT_EQ(mesh.facets.size(), 26U) << "one of the edges is divided";
    EXPECT_NEAR(signed_volume(mesh), turned ? -2.0 : 2.0, 1e-12);
    // As solids they come apart; as voids in something larger the material between them hangs together.
    EXPECT_EQ(mesh.vertices.size(), turned ? 15U : 17U);
    EXPECT_EQ(weld_equal(mesh), 15U);
    EXPECT_EQ(edges_of_other_than_two(mesh), 0U);
    EXPECT_EQ(split_touching(mesh), 0U);
  }
}

}  // namespace
}  // namespace moldlight
