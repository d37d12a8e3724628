// The axis of a round wall: cylinders and cones, whole and in part.
#include "mold/round_wall.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "support/boxes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

/// A wall of this draft over a polygon that turns by `turn_deg` and, where that is no full turn, through the
/// axis.
TriangleMesh drafted(int sides, double draft_deg, double turn_deg = 360.0) {
  constexpr double k_height = 12.0, k_radius = 9.0;
  const double above = k_radius - k_height * std::tan(glm::radians(draft_deg));
  test::Loop2 low, high;
  if (turn_deg < 360.0) low.emplace_back(0.0), high.emplace_back(0.0);
  for (int k = 0; k < sides + (turn_deg < 360.0 ? 1 : 0); ++k) {
    const double angle = glm::radians(turn_deg * k / sides);
    const glm::dvec2 spoke(std::cos(angle), std::sin(angle));
    low.push_back(k_radius * spoke);
    high.push_back(above * spoke);
  }
  test::SolidBuilder solid;
  const test::Loop bottom = test::at_height(low, 0.0), top = test::at_height(high, k_height);
  solid.face({bottom.rbegin(), bottom.rend()});
  solid.face(top);
  solid.walls(bottom, top);
  return solid.mesh();
}

/// Angle between z and the axis of the wall around each of its facets, the largest; 90 where one has no axis.
double worst_deg(const TriangleMesh& mesh) {
  const FacetGeometry geometry = facet_geometry(mesh);
  const Adjacency adjacency = build_adjacency(mesh);
  double worst = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3& normal = geometry.normals[facet];
    const glm::dvec3 middle = (mesh.corner(facet, 0) + mesh.corner(facet, 1) + mesh.corner(facet, 2)) / 3.0;
    const bool on_wall = glm::dot(glm::dvec2(normal), glm::normalize(glm::dvec2(middle))) > 0.8;
    if (!on_wall) continue;
    const auto wall = round_wall(geometry, adjacency, facet);
    worst = std::max(worst, wall ? glm::degrees(std::acos(std::min(1.0, std::abs(wall->axis.z)))) : 90.0);
  }
  return worst;
}

TEST(RoundWall, AConeHasTheAxisOfItsCylinder) {
  for (const double draft_deg : {0.0, 0.5, 1.0, 3.0, 5.0, 20.0}) {
    for (const int sides : {12, 24, 90}) EXPECT_LT(worst_deg(drafted(sides, draft_deg)), 0.01) << draft_deg;
    EXPECT_LT(worst_deg(drafted(10, draft_deg, 120.0)), 0.01) << draft_deg << " in part";
  }
}

/// Some circle goes through the normals of a plane and of a cone that begins in it.
TEST(RoundWall, APlaneAroundACountersinkHasNone) {
  for (const int sides : {40, 64}) {
    for (const double deep : {1.15, 2.0, 3.0}) {
      const test::Loop2 wide = test::regular_polygon(sides, 4.0), narrow = test::regular_polygon(sides, 2.0);
      const test::Loop2 rim = {{-20, -15}, {20, -15}, {20, 15}, {-20, 15}};
      test::SolidBuilder solid;
      test::Loop bottom = test::at_height(rim, -6.0), hole = test::at_height(narrow, -6.0);
      solid.walls(bottom, test::at_height(rim, 0.0));
      std::ranges::reverse(bottom);
      solid.face(bottom, {hole});
      solid.face(test::at_height(rim, 0.0), {test::at_height(wide, 0.0)});
      test::Loop low = test::at_height(narrow, -deep), high = test::at_height(wide, 0.0);
      for (test::Loop* loop : {&low, &high, &hole}) std::ranges::reverse(*loop);
      solid.walls(low, high);
      solid.walls(hole, low);
      const TriangleMesh mesh = solid.mesh();
      const FacetGeometry geometry = facet_geometry(mesh);
      const Adjacency adjacency = build_adjacency(mesh);
      for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
        const bool top = geometry.normals[facet].z > 0.999;
        const auto wall = round_wall(geometry, adjacency, facet);
        if (top) {
          EXPECT_FALSE(wall) << sides << " sides, " << deep << " deep";
        }
        if (std::abs(geometry.normals[facet].z) < 0.9 && wall) {
          EXPECT_GT(std::abs(wall->axis.z), 0.9999) << sides << " sides, " << deep << " deep";
        }
      }
    }
  }
}

TEST(RoundWall, APlaneHasNone) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
  EXPECT_FALSE(round_wall(facet_geometry(box), build_adjacency(box), 0));
}

}  // namespace
}  // namespace moldlight
