// Draft of solids whose walls have known angles, and the walls turned as is suggested.
#include "parting/draft/draft_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/scratch_folder.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::at_height;
using test::Loop2;
using test::model_of;
using test::SolidBuilder;

Loop2 reversed(const Loop2& loop) { return {loop.rbegin(), loop.rend()}; }

double tangent(double degrees) { return std::tan(glm::radians(degrees)); }

DraftCheck check_of(const PartModel& model, double required_deg, double tolerance = 0.0) {
  Query query{glm::dvec3(0, 0, 1), {}};
  query.method.tolerance = tolerance;
  const Classification result = classify_exact(model, query, Progress{});
  const Assignment assignment = assign_sides(model, query, {}, Progress{});
  const DraftCheck check = check_draft(model, assignment, result.reverse_draft, {required_deg});
  double binned = 0.0;
  for (const DraftBin& bin : check.histogram) binned += bin.area[0] + bin.area[1];
  EXPECT_NEAR(binned, assignment.area(MoldSide::core) + assignment.area(MoldSide::cavity), 1e-9 * binned);
  return check;
}

/// Stands on its large end; all walls have this draft.
TriangleMesh frustum(const Loop2& foot, const Loop2& top, double height) {
  SolidBuilder solid;
  solid.face(at_height(reversed(foot), 0.0));
  solid.face(at_height(top, height));
  solid.walls(at_height(foot, 0.0), at_height(top, height));
  return solid.mesh();
}

/// A block that narrows upward by this draft on all sides.
TriangleMesh drafted_box(double draft_deg) {
  const double in = 8.0 * tangent(draft_deg);
  return frustum({{0, 0}, {20, 0}, {20, 12}, {0, 12}},
                 {{in, in}, {20 - in, in}, {20 - in, 12 - in}, {in, 12 - in}}, 8.0);
}

TEST(DraftCheck, OfAConeIsThatOfItsWall) {
  // Walls of a pyramid of many sides lean by its apothem, not by its corners.
  constexpr int k_sides = 48;
  constexpr double k_height = 10.0, k_draft_deg = 2.0;
  const double shrink = 1.0 / std::cos(std::numbers::pi / k_sides);
  const Loop2 foot = test::regular_polygon(k_sides, 6.0 * shrink),
              top = test::regular_polygon(k_sides, (6.0 - k_height * tangent(k_draft_deg)) * shrink);
  const auto model = model_of(frustum(foot, top, k_height));
  const double wall = 0.5 * (test::polygon_perimeter(foot) + test::polygon_perimeter(top)) * k_height /
                      std::cos(glm::radians(k_draft_deg));
  const DraftCheck enough = check_of(*model, 1.9), less = check_of(*model, 3.0);
  EXPECT_EQ(enough.below[0] + enough.below[1], 0.0);
  EXPECT_TRUE(enough.walls.empty());
  EXPECT_NEAR(less.below[0], wall, 1e-9 * wall);
  EXPECT_EQ(less.below[1], 0.0);
  ASSERT_EQ(less.walls.size(), 1U) << "a round wall is one face";
  EXPECT_FALSE(less.walls[0].foot_line) << "and has no straight foot";
  EXPECT_NEAR(less.walls[0].turn_deg, 1.0, 1e-6);
  EXPECT_NEAR(less.walls[0].thickness, k_height * (tangent(3.0) - tangent(2.0)), 1e-6);
  EXPECT_EQ(less.reverse.area, 0.0);
  for (const DraftBin& bin : less.histogram) {
    const bool here = bin.from_deg == k_draft_deg;
    if (bin.to_deg < 90.0 && bin.from_deg > -90.0) {
      EXPECT_NEAR(bin.area[0], here ? wall : 0.0, 1e-9 * wall);
    }
  }
}

TEST(DraftCheck, AWallIsTurnedAboutItsFootToTheAngle) {
  for (const double draft_deg : {0.0, 0.4}) {
    const auto model = model_of(drafted_box(draft_deg));
    const DraftCheck check = check_of(*model, 1.5);
    const double slant = 8.0 / std::cos(glm::radians(draft_deg)), in = 8.0 * tangent(draft_deg);
    const double area = slant * (2.0 * (20.0 - in) + 2.0 * (12.0 - in));
    EXPECT_NEAR(check.below[0] + check.below[1], area, 1e-9 * area);
    ASSERT_EQ(check.walls.size(), 4U);
    TriangleMesh turned = drafted_box(draft_deg);
    for (const WallDraft& wall : check.walls) {
      EXPECT_NEAR(wall.turn_deg, 1.5 - draft_deg, 1e-6);
      ASSERT_TRUE(wall.foot_line);
      const auto& [from, to] = *wall.foot_line;
      const double outward = wall.side == MoldSide::core ? 1.0 : -1.0;
      EXPECT_NEAR(from.z, wall.foot, 1e-9);
      EXPECT_NEAR(to.z, wall.foot, 1e-9);
      EXPECT_NEAR(wall.foot, outward > 0.0 ? 0.0 : 8.0, 1e-9);
      // The wall's own corners recede into the part.
      const glm::dvec3 middle(10, 6, wall.foot), inward = glm::normalize(middle - 0.5 * (from + to));
      const glm::dvec3 normal = glm::normalize(glm::cross(to - from, glm::dvec3(0, 0, 1)));
      const glm::dvec3 into = glm::dot(normal, inward) > 0.0 ? normal : -normal;
      std::size_t moved = 0;
      for (glm::dvec3& p : turned.vertices) {
        const double above = outward * (p.z - wall.foot);
        const double behind = glm::dot(p - from, into) - above * tangent(draft_deg);
        if (above < 1e-9 || std::abs(behind) > 1e-6) continue;
        p += into * (above / wall.height * wall.thickness);
        ++moved;
      }
      EXPECT_EQ(moved, 2U);
    }
    const auto changed = model_of(std::move(turned));
    const DraftCheck after = check_of(*changed, 1.5);
    EXPECT_EQ(after.below[0] + after.below[1], 0.0);
    EXPECT_NEAR(check_of(*changed, 1.6).walls.front().least_deg, 1.5, 1e-6) << "and no more than asked";
  }
}

TEST(DraftCheck, ASliverDoesNotTurnItsWall) {
  // On the wall y = 0, whose facets are one face of CAD, the tip of a needle stands out by little.
  constexpr double k_out = 0.001, k_size = 0.1;
  TriangleMesh mesh = drafted_box(0.0);
  const auto corner = [&](double x, double z) {
    const auto found = std::ranges::find(mesh.vertices, glm::dvec3(x, 0.0, z));
    return static_cast<VertexIndex>(found - mesh.vertices.begin());
  };
  const auto add = [&](double x, double y, double z) {
    mesh.vertices.emplace_back(x, y, z);
    return static_cast<VertexIndex>(mesh.vertices.size() - 1);
  };
  const auto on_wall = [&](const std::array<VertexIndex, 3>& facet) {
    return std::ranges::all_of(facet, [&](VertexIndex v) { return mesh.vertices[v].y == 0.0; });
  };
  std::erase_if(mesh.facets, on_wall);
  const std::size_t others = mesh.facets.size();
  const VertexIndex a = corner(0, 0), b = corner(20, 0), c = corner(20, 8), d = corner(0, 8);
  const VertexIndex p = add(10 - k_size, 0, 4 - k_size), q = add(10 + k_size, 0, 4 - k_size),
                    r = add(10, 0, 4 + k_size), tip = add(10, -k_out, 4);
  for (const std::array<VertexIndex, 3>& facet : {std::array{a, b, q},
                                                  {a, q, p},
                                                  {b, c, r},
                                                  {b, r, q},
                                                  {c, d, r},
                                                  {d, a, p},
                                                  {d, p, r},
                                                  {p, q, tip},
                                                  {q, r, tip},
                                                  {r, p, tip}})
    mesh.facets.push_back(facet);
  Part part;
  part.file = "(test)";
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  part.mesh = mesh;
  part.has_cad_faces = true;
  part.facet_source.assign(mesh.facets.size(), 1);
  std::fill_n(part.facet_source.begin(), others, 0U);
  const auto model = prepare_part(std::move(part), Progress{});
  const DraftCheck check = check_of(*model, 1.0, 0.01);
  const auto wall = std::ranges::find(check.walls, 1U, &WallDraft::face);
  ASSERT_NE(wall, check.walls.end());
  EXPECT_LT(wall->least_deg, -0.5) << "the needle's underside leans back";
  EXPECT_NEAR(wall->turn_deg, 1.0, 1e-6) << "but the wall is turned as it stands";
}

TEST(DraftCheck, FacetsOfAFilletCountOneByOne) {
  // A bar whose upper edge is rounded by nine chords: facets of 5, 15, … 85 degrees.
  constexpr double k_radius = 4.0, k_length = 30.0;
  constexpr int k_chords = 9;
  Loop2 profile = {{0, 0}, {10, 0}};
  for (int k = 0; k <= k_chords; ++k) {
    const double angle = std::numbers::pi / 2.0 * k / k_chords;
    profile.emplace_back(10.0 - k_radius + k_radius * std::cos(angle), 6.0 + k_radius * std::sin(angle));
  }
  profile.emplace_back(0, 10);
  SolidBuilder solid;
  solid.extrude(profile, {}, k_length);
  const auto model = model_of(solid.mesh());
  const double chord = 2.0 * k_radius * std::sin(std::numbers::pi / 4.0 / k_chords) * k_length;
  const DraftCheck few = check_of(*model, 4.9), one = check_of(*model, 5.1), two = check_of(*model, 15.1);
  const auto below = [](const DraftCheck& check) { return check.below[0] + check.below[1]; };
  EXPECT_NEAR(below(one) - below(few), chord, 1e-9 * chord);
  EXPECT_NEAR(below(two) - below(one), chord, 1e-9 * chord);
}

TEST(DraftCheck, AWallThatLeansAgainstItsHalfIsReverse) {
  // A pocket in the top whose one wall overhangs by 0.6 degrees, within tau of 1: only the core reaches it.
  constexpr double k_lean_deg = 0.6, k_depth = 5.0;
  const double back = k_depth * tangent(k_lean_deg);
  const Loop2 block = {{0, 0}, {20, 0}, {20, 12}, {0, 12}}, mouth = {{4, 3}, {16, 3}, {16, 9}, {4, 9}},
              floor = {{4, 3}, {16 + back, 3}, {16 + back, 9}, {4, 9}};
  SolidBuilder solid;
  solid.face(at_height(reversed(block), 0.0));
  solid.face(at_height(block, 8.0), {at_height(reversed(mouth), 8.0)});
  solid.walls(at_height(block, 0.0), at_height(block, 8.0));
  solid.walls(at_height(reversed(floor), 8.0 - k_depth), at_height(reversed(mouth), 8.0));
  solid.face(at_height(floor, 8.0 - k_depth));
  const auto model = model_of(solid.mesh());
  // Within the lateral tolerance, so that the wall is no undercut.
  const DraftCheck check = check_of(*model, 0.5, 2.0 * back);
  EXPECT_NEAR(check.reverse.worst_deg, k_lean_deg, 1e-6);
  const double area = 6.0 * k_depth / std::cos(glm::radians(k_lean_deg));
  EXPECT_NEAR(check.reverse.area, area, 1e-9 * area);
  ASSERT_TRUE(check.reverse.facet);
  EXPECT_NEAR(model->geometry.normals[*check.reverse.facet].x, -std::cos(glm::radians(k_lean_deg)), 1e-9);
  ASSERT_FALSE(check.walls.empty());
  EXPECT_NEAR(check.walls.front().least_deg, -k_lean_deg, 1e-6) << "it costs most";
  EXPECT_NEAR(check.walls.front().turn_deg, 0.5 + k_lean_deg, 1e-6);
}

TEST(DraftCheck, TheTableHasALineAWall) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("draft.csv");
  const DraftCheck check = check_of(*model_of(drafted_box(0.4)), 1.5);
  write_draft_csv(path, check);
  const std::string table = test::file_bytes(path);
  EXPECT_EQ(std::ranges::count(table, '\n'), 5);
  EXPECT_NE(table.find("\n" + std::to_string(check.walls.front().face) + ","), std::string::npos);
}

}  // namespace
}  // namespace moldlight
