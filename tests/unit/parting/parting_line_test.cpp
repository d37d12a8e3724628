// Parting lines of solids for which they are known.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/faces.hpp"
#include "parting/loops.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::model_of;

struct Found {
  std::shared_ptr<const PartModel> model;
  Assignment assignment;
  PartingLine line;
  [[nodiscard]] std::string verdict() const { return parting_verdict(assignment, line, *model); }
};

Found find(TriangleMesh mesh, const glm::dvec3& direction = {0, 0, 1}, const MoldSettings& settings = {}) {
  Found found;
  found.model = model_of(std::move(mesh));
  found.assignment = assign_sides(*found.model, {direction, {}}, settings, Progress{});
  found.line = parting_line(found.assignment);
  const double slack = 1e-9 * found.assignment.energy;
  EXPECT_LE(found.assignment.energy, found.assignment.energy_to_core + slack);
  EXPECT_LE(found.assignment.energy, found.assignment.energy_to_cavity + slack);
  EXPECT_TRUE(found.line.euler.sums());
  EXPECT_TRUE(found.line.euler.accounted());
  double areas = 0.0;
  for (const MoldSide side : k_mold_sides) areas += found.assignment.area(side);
  EXPECT_NEAR(areas, found.model->geometry.total_area, 1e-9 * areas);
  return found;
}

void expect_loops(const Found& found, std::size_t shut_offs) {
  EXPECT_EQ(found.assignment.area(MoldSide::action), 0.0);
  EXPECT_EQ(found.line.euler.loops, shut_offs + 1);
  EXPECT_EQ(found.line.euler.expected_loops, shut_offs + 1);
  EXPECT_EQ(found.line.euler.core, 2 - static_cast<std::int64_t>(shut_offs + 1));
  EXPECT_EQ(found.line.euler.cavity, found.line.euler.core);
  ASSERT_EQ(found.line.loops.size(), shut_offs + 1);
  for (std::size_t k = 0; k < found.line.loops.size(); ++k)
    EXPECT_EQ(found.line.loops[k].kind, k == 0 ? LoopKind::outer : LoopKind::shut_off);
}

TEST(PartingLine, IsTinyUpToACircleAsWideAsTheTolerance) {
  PartingLoop loop;
  loop.area = 0.003;
  loop.length = 0.157;
  EXPECT_TRUE(is_tiny(loop, 0.05));
  loop.length = 0.158;
  EXPECT_FALSE(is_tiny(loop, 0.05));
  // A short sliver is as little of a shut-off, unless it is a window in a wall.
  loop.area = -0.002;
  loop.length = 0.3;
  EXPECT_TRUE(is_tiny(loop, 0.05));
  loop.high = 0.06;
  EXPECT_FALSE(is_tiny(loop, 0.05));
}

TEST(PartingLine, OfABoxGoesOnceAroundIt) {
  const Found found = find(test::box_mesh({0, 0, 0}, {4, 3, 2}));
  expect_loops(found, 0);
  const PartingLoop& loop = found.line.loops[0];
  EXPECT_NEAR(loop.length, 14.0, 1e-9);
  EXPECT_NEAR(loop.climb(), 0.0, 1e-9);
  EXPECT_NEAR(loop.flatness, 0.0, 1e-9);
  EXPECT_NEAR(loop.sharpest_deg, 90.0, 1e-6);
  EXPECT_NEAR(loop.on_crease, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(loop.area), 12.0, 1e-9);
  EXPECT_NE(found.verdict().find("Parting line: planar at z = "), std::string::npos) << found.verdict();
  EXPECT_NE(found.verdict().find("No shut-offs."), std::string::npos) << found.verdict();
}

/// Upright walls in a corner hide needles of each other once their corners are rounded.
TEST(PartingLine, OfWallsThatRoundingLeansIsPlanar) {
  test::SolidBuilder builder;
  builder.extrude(
      {{0, 0}, {60, 0}, {60, 18}, {50, 18}, {50, 15}, {56, 15}, {56, 4}, {4, 4}, {4, 12}, {0, 12}}, {}, 20.0);
  const TriangleMesh mesh = builder.mesh();
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const glm::dquat turn = test::random_rotation(seed);
    const Found found = find(test::rounded_to_float(test::rotated(mesh, turn)), turn * glm::dvec3(0, 1, 0));
    const PartingLoop& outer = found.line.loops.front();
    EXPECT_NEAR(outer.length, 184.0, 1e-4) << "turn " << seed;
    EXPECT_EQ(outer.steep_length, 0.0) << "turn " << seed;
    EXPECT_NE(found.verdict().find("Parting line: planar"), std::string::npos) << found.verdict();
  }
}

/// Nor do strips of a hole across the direction make shut-offs of their own.
TEST(PartingLine, OfAHoleAcrossHasNoShutOffByRounding) {
  test::SolidBuilder builder;
  test::Loop2 hole = test::regular_polygon(48, 3.0, 1.3);
  for (glm::dvec2& corner : hole) corner += glm::dvec2(20.0, 8.0);
  builder.extrude({{0, 0}, {40, 0}, {40, 16}, {0, 16}}, {hole}, 20.0);
  const TriangleMesh mesh = builder.mesh();
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const glm::dquat turn = test::random_rotation(seed);
    const Found found = find(test::rounded_to_float(test::rotated(mesh, turn)), turn * glm::dvec3(0, 0, 1));
    EXPECT_EQ(std::ranges::count(found.line.loops, LoopKind::shut_off, &PartingLoop::kind), 0)
        << "turn " << seed;
  }
}

TEST(PartingLine, SaysOfWhichLoopsItsStepsAre) {
  Found found = find(test::box_mesh({0, 0, 0}, {4, 3, 2}));
  PartingLoop stepped = found.line.loops[0];
  stepped.kind = LoopKind::shut_off;
  stepped.steepest_deg = 90.0;
  stepped.steep_length = 1.5;
  found.line.loops.push_back(stepped);
  EXPECT_NE(found.verdict().find("planar at z = 0 unit. 1 shut-off with 1.5 unit of steps of up to 90°."),
            std::string::npos)
      << found.verdict();
  found.line.loops[0].steepest_deg = 88.0;
  found.line.loops[0].steep_length = 0.5;
  EXPECT_NE(
      found.verdict().find("planar at z = 0 unit, 0.5 unit of steps of up to 88°. 1 shut-off with 1.5 unit"),
      std::string::npos)
      << found.verdict();
}

TEST(PartingLine, RunsAtTheHeightThatIsGiven) {
  MoldSettings settings;
  settings.parting_height = 0.7;
  const Found found = find(test::box_mesh({0, 0, 0}, {4, 3, 2}), {0, 0, 1}, settings);
  expect_loops(found, 0);
  EXPECT_NEAR(found.line.loops[0].low, 0.7, 1e-12);
  EXPECT_NEAR(found.line.loops[0].high, 0.7, 1e-12);
  EXPECT_NEAR(found.line.loops[0].length, 14.0, 1e-9);
  EXPECT_NEAR(found.assignment.area(MoldSide::core), 12.0 + 14.0 * 1.3, 1e-9);
  EXPECT_NEAR(found.assignment.area(MoldSide::cavity), 12.0 + 14.0 * 0.7, 1e-9);
  for (const double outside : {-0.1, 2.1}) {
    settings.parting_height = outside;
    EXPECT_THROW(find(test::box_mesh({0, 0, 0}, {4, 3, 2}), {0, 0, 1}, settings), UsageError) << outside;
  }
}

TEST(PartingLine, GivesCosmeticFacesToTheirHalf) {
  const auto model = model_of(test::box_mesh({0, 0, 0}, {4, 3, 2}));
  for (const char* half : {"core", "cavity"}) {
    MoldSettings settings;
    settings.cosmetic = std::string(half) + ":0,1,2,3,4,5";
    const Assignment assignment = assign_sides(*model, {glm::dvec3(0, 0, 1), {}}, settings, Progress{});
    EXPECT_NEAR(assignment.area(half == std::string("core") ? MoldSide::core : MoldSide::cavity), 40.0, 1e-9);
    EXPECT_EQ(assignment.warnings.size(), 1U) << "the face on the other half's side stays there";
  }
  MoldSettings settings;
  settings.cosmetic = "core:6";
  EXPECT_THROW(static_cast<void>(assign_sides(*model, {glm::dvec3(0, 0, 1), {}}, settings, Progress{})),
               UsageError);
  EXPECT_THROW(static_cast<void>(parse_cosmetic("lid:1")), UsageError);
  EXPECT_THROW(static_cast<void>(parse_cosmetic("core:")), UsageError);
  EXPECT_THROW(static_cast<void>(parse_cosmetic("core:1,x")), UsageError);
}

TEST(PartingLine, TakesCosmeticFacesOfBothHalves) {
  const auto model = model_of(test::box_mesh({0, 0, 0}, {4, 3, 2}));
  const Faces faces = part_faces(model->part, model->geometry, model->adjacency);
  std::vector<std::uint32_t> walls;  // of 3 by 2, then of 4 by 2
  for (const double nx : {1.0, 0.0}) {
    for (std::uint32_t face = 0; face < faces.count(); ++face) {
      const glm::dvec3 normal = model->geometry.normals[faces.facets(face).front()];
      if (normal.z == 0.0 && std::abs(normal.x) == nx) walls.push_back(face);
    }
  }
  ASSERT_EQ(walls.size(), 4U);
  MoldSettings settings;
  for (std::size_t k = 0; k < 4; ++k) settings.cosmetic = cosmetic_with(settings.cosmetic, walls[k], k < 2);
  const auto area_of_core = [&] {
    return assign_sides(*model, {glm::dvec3(0, 0, 1), {}}, settings, Progress{}).area(MoldSide::core);
  };
  EXPECT_NEAR(area_of_core(), 12.0 + 12.0, 1e-9) << settings.cosmetic;
  settings.cosmetic = cosmetic_with(settings.cosmetic, walls[0], false);
  EXPECT_NEAR(area_of_core(), 12.0 + 6.0, 1e-9) << settings.cosmetic;

  EXPECT_EQ(cosmetic_with("cavity:3/core:5,1", 2, true), "core:1,2,5/cavity:3");
  EXPECT_EQ(cosmetic_with("core:1/cavity:3", 3, true), "core:1,3");
  EXPECT_EQ(cosmetic_with("core:1", 1, std::nullopt), "");
  EXPECT_EQ(cosmetic_faces("core:7,2,2/cavity:1", true), (std::vector<std::uint32_t>{2, 7}));
}

TEST(PartingLine, OfACupIsItsRim) {
  const test::Shape cup = test::cup({});
  const Found found = find(cup.mesh, cup.direction);
  EXPECT_EQ(found.line.euler.loops, 1U);
  EXPECT_EQ(found.line.euler.expected_loops, 1U);
  EXPECT_NEAR(found.line.loops[0].climb(), 0.0, 1e-9);
}

/// Two steps: the line may run along the lower one's edge or around the foot, level in any case.
/// Both ends of its walls are as long and as level: only the rim's spares a half the slot as narrow as they
/// are.
TEST(PartingLine, OfABoxWithoutDraftIsAtItsOpenSide) {
  for (const bool open_above : {true, false}) {
    const glm::dvec3 low(0, 0, 0), high(80, 60, 25), void_low(2, 2, open_above ? 2 : 0),
        void_high(78, 58, open_above ? 25 : 23);
    const int side = open_above ? 5 : 4;
    test::SolidBuilder solid;
    solid.box(low, high, {side});
    solid.box(void_low, void_high, {side}, true);
    solid.face(test::box_face(low, high, side), {test::box_face(void_low, void_high, side)});
    const Found found = find(solid.mesh());
    ASSERT_EQ(found.line.loops.size(), 1U);
    EXPECT_NEAR(found.line.outer_low, open_above ? 25.0 : 0.0, 1e-9);
    EXPECT_NEAR(found.line.outer_high, open_above ? 25.0 : 0.0, 1e-9);
    EXPECT_NEAR(found.line.length, 280.0, 1e-9);
  }
}

TEST(PartingLine, OfASteppedBlockIsLevel) {
  test::SolidBuilder builder;
  builder.extrude({{0, 0}, {8, 0}, {8, 2}, {5, 2}, {5, 4}, {0, 4}}, {}, 3.0);
  const Found found = find(builder.mesh());
  expect_loops(found, 0);
  EXPECT_NEAR(found.line.loops[0].length, 2 * (8.0 + 3.0), 1e-9);
  EXPECT_NEAR(found.line.loops[0].climb(), 0.0, 1e-9);
}

TEST(PartingLine, OfASaddleFollowsItsRim) {
  constexpr int k_corners = 90;
  const auto saddle = [](double x, double y) { return 0.02 * (x * x - y * y); };
  const Found found = find(test::sheet_mesh(k_corners, 10.0, 0.5, saddle));
  expect_loops(found, 0);
  double length = 0.0, low = INFINITY, high = -INFINITY;
  glm::dvec3 before;
  for (int k = 0; k <= k_corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / k_corners;
    const double x = 10.0 * std::cos(angle), y = 10.0 * std::sin(angle);
    const glm::dvec3 at(x, y, saddle(x, y));
    if (k > 0) length += glm::distance(at, before);
    before = at;
    low = std::min(low, at.z);
    high = std::max(high, at.z);
  }
  EXPECT_NEAR(found.line.loops[0].length, length, 1e-9 * length);
  EXPECT_NEAR(found.line.loops[0].climb(), high - low, 1e-9);
  EXPECT_GT(found.line.loops[0].flatness, 1.0);
  EXPECT_NE(found.verdict().find("stepped, "), std::string::npos) << found.verdict();
}

TEST(PartingLine, OfAPlateHasAShutOffForEveryHole) {
  for (const auto& [rows, columns] : {std::pair{1, 1}, {1, 2}, {5, 10}}) {
    const Found found = find(test::plate_with_holes(rows, columns, 2.0));
    expect_loops(found, static_cast<std::size_t>(rows * columns));
    EXPECT_NEAR(found.line.loops[0].length, 20.0 * (rows + columns), 1e-9);
    for (const PartingLoop& loop : found.line.loops) {
      EXPECT_NEAR(loop.climb(), 0.0, 1e-9);
      if (loop.kind == LoopKind::shut_off) {
        EXPECT_NEAR(loop.length, 16.0, 1e-9);
      }
    }
  }
}

TEST(PartingLine, OfALyingTorusIsTwoRings) {
  constexpr int k_around = 60;
  const Found found = find(test::torus_mesh(10.0, 2.0, k_around, 24));
  expect_loops(found, 1);
  const double half = std::sin(std::numbers::pi / k_around);
  EXPECT_NEAR(found.line.loops[0].length, 2.0 * k_around * 12.0 * half, 1e-6);
  EXPECT_NEAR(found.line.loops[1].length, 2.0 * k_around * 8.0 * half, 1e-6);
  EXPECT_NEAR(found.line.low, 0.0, 1e-9);
  EXPECT_NEAR(found.line.high, 0.0, 1e-9);
}

/// Seen along its plane: half a section around either side, half a ring along the top and the bottom. Inside,
/// each half of the ring hides the other, and actions break the line.
TEST(PartingLine, OfAnUprightTorusFollowsItsTop) {
  const Found found = find(test::torus_mesh(10.0, 2.0, 60, 24), {1, 0, 0});
  EXPECT_GT(found.assignment.area(MoldSide::action), 0.0);
  EXPECT_EQ(found.line.euler.genus, 1);
  ASSERT_FALSE(found.line.loops.empty());
  const PartingLoop& outer = found.line.loops[0];
  EXPECT_EQ(outer.kind, LoopKind::outer);
  EXPECT_NEAR(outer.climb(), 0.0, 1e-9) << "of what no action breaks";
  EXPECT_GT(outer.breaks, 0U);
  EXPECT_NEAR(outer.length, 2.0 * std::numbers::pi * (10.0 + 2.0), 1.0);
}

/// A quarter turn of a hollow tube in the plane across the direction: the halves meet in its plane outside,
/// and its inside is an undercut.
TEST(PartingLine, OfAnElbowLiesInItsPlane) {
  test::TubeShape elbow{.centres = {}, .radius = 3.0, .inner_radius = 2.0, .normal = {0, 0, 1}};
  constexpr int k_sections = 24;
  for (int k = 0; k <= k_sections; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / k_sections;
    elbow.centres.emplace_back(20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0);
  }
  const Found found = find(test::tube_mesh(elbow));
  EXPECT_EQ(found.line.euler.part, 0);
  EXPECT_EQ(found.line.euler.genus, 1);
  EXPECT_NEAR(found.assignment.area(MoldSide::action) / found.model->geometry.total_area, 0.39, 0.02);
  ASSERT_GE(found.line.loops.size(), 1U);
  EXPECT_EQ(found.line.loops[0].kind, LoopKind::outer);
  double on_curves = 0.0;
  const PartingLoop& outer = found.line.loops[0];
  for (std::size_t k = 0; k < outer.vertices.size(); ++k) {
    const glm::dvec3 &a = found.assignment.mesh.vertices[outer.vertices[k]],
                     &b = found.assignment.mesh.vertices[outer.vertices[(k + 1) % outer.vertices.size()]];
    if (std::abs(a.z) < 1e-9 && std::abs(b.z) < 1e-9) on_curves += glm::distance(a, b);
  }
  const double section = 2.0 * std::sin(0.25 * std::numbers::pi / k_sections);
  EXPECT_GT(on_curves, 0.98 * k_sections * section * (23.0 + 17.0));
}

TEST(PartingLine, OfSeveralBodiesIsOneSetEach) {
  const Found found =
      find(test::joined(test::box_mesh({0, 0, 0}, {4, 3, 2}), test::box_mesh({10, 0, 0}, {12, 3, 2})));
  EXPECT_EQ(found.line.euler.bodies, 2U);
  ASSERT_EQ(found.line.loops.size(), 2U);
  for (const PartingLoop& loop : found.line.loops) EXPECT_EQ(loop.kind, LoopKind::outer);
  EXPECT_EQ(found.line.euler.expected_loops, 2U);
}

TEST(PartingLine, OfAReversedDirectionIsTheSame) {
  const Found up = find(test::plate_with_holes(1, 2, 2.0)),
              down = find(test::plate_with_holes(1, 2, 2.0), {0, 0, -1});
  EXPECT_NEAR(up.line.length, down.line.length, 1e-9);
  EXPECT_EQ(up.line.euler.loops, down.line.euler.loops);
}

}  // namespace
}  // namespace moldlight
