// Solids whose parting line and mold are known by formula, in other sizes, far from the origin, turned: all
// of it is the same but for the size.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "parting/loops.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_files.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/mesh_edits.hpp"
#include "support/mold_checks.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

struct KnownMold {
  std::string name;
  TriangleMesh mesh;
  double outer_length = 0.0, outer_climb = 0.0;
  std::size_t shut_offs = 0;
  double shut_off_length = 0.0;  // of all of them
  double part_volume = 0.0;
  double slack = 1e-9;  // of lengths, as shares of the outer line
};

double ring_length(double radius, int corners) {
  return 2.0 * corners * radius * std::sin(std::numbers::pi / corners);
}

KnownMold stepped_block() {
  test::SolidBuilder block;  // its profile is in x and z
  block.extrude({{0, 0}, {8, 0}, {8, 2}, {5, 2}, {5, 4}, {0, 4}}, {}, 3.0);
  KnownMold known{.name = "stepped block", .mesh = block.mesh()};
  known.outer_length = 2.0 * (8.0 + 3.0);
  known.part_volume = 26.0 * 3.0;
  return known;
}

KnownMold saddle() {
  constexpr int k_corners = 90;
  const auto height = [](double x, double y) { return 0.02 * (x * x - y * y); };
  KnownMold known{.name = "saddle", .mesh = test::sheet_mesh(k_corners, 10.0, 0.5, height)};
  glm::dvec3 before(10.0, 0.0, height(10.0, 0.0));
  for (int k = 1; k <= k_corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / k_corners;
    const glm::dvec2 at(10.0 * std::cos(angle), 10.0 * std::sin(angle));
    const glm::dvec3 next(at, height(at.x, at.y));
    known.outer_length += glm::distance(before, next);
    before = next;
  }
  double low = INFINITY, high = -INFINITY;
  for (const glm::dvec3& v : known.mesh.vertices) {
    if (std::abs(glm::length(glm::dvec2(v)) - 10.0) > 1e-9) continue;
    low = std::min(low, v.z);
    high = std::max(high, v.z);
  }
  known.outer_climb = high - low - 0.5;
  known.part_volume = 0.5 * 0.5 * k_corners * 100.0 * std::sin(2.0 * std::numbers::pi / k_corners);
  return known;
}

std::vector<KnownMold> known_molds() {
  std::vector<KnownMold> all;
  all.push_back({.name = "box",
                 .mesh = test::box_mesh({0, 0, 0}, {4, 3, 2}),
                 .outer_length = 14.0,
                 .part_volume = 24.0});
  const test::Shape cup = test::cup({});
  const Bounds box = bounds(cup.mesh);
  all.push_back({.name = "cup",
                 .mesh = cup.mesh,
                 .outer_length = 2.0 * (box.max.x - box.min.x + box.max.y - box.min.y),
                 .part_volume = signed_volume(cup.mesh)});
  all.push_back(stepped_block());
  all.push_back(saddle());
  for (const auto& [rows, columns] : {std::pair{1, 1}, {1, 2}, {5, 10}}) {
    const int holes = rows * columns;
    all.push_back({.name = fmt::format("plate with {} holes", holes),
                   .mesh = test::plate_with_holes(rows, columns, 2.0),
                   .outer_length = 20.0 * (rows + columns),
                   .shut_offs = static_cast<std::size_t>(holes),
                   .shut_off_length = 16.0 * holes,
                   .part_volume = 2.0 * (100.0 - 16.0) * holes});
  }
  all.push_back({.name = "lying torus",
                 .mesh = test::torus_mesh(10.0, 2.0, 60, 24),
                 .outer_length = ring_length(12.0, 60),
                 .shut_offs = 1,
                 .shut_off_length = ring_length(8.0, 60),
                 .part_volume = std::abs(signed_volume(test::torus_mesh(10.0, 2.0, 60, 24)))});
  return all;
}

/// How a known solid lies: its own size, a turn, a place in sizes of it.
struct Pose {
  std::string name;
  double scale = 1.0;
  std::uint32_t turn = 0;  // seed of a rotation; 0: none
  glm::dvec3 offset{0.0};  // in diagonals
  double slack = 1e-9;     // coordinates far away have fewer digits
};

void expect_known(const KnownMold& known, const Pose& pose) {
  const std::string name = known.name + ", " + pose.name;
  TriangleMesh mesh = test::scaled(known.mesh, pose.scale);
  glm::dvec3 direction(0, 0, 1);
  if (pose.turn != 0) {
    const glm::dquat turn = test::random_rotation(pose.turn);
    mesh = test::rotated(std::move(mesh), turn);
    direction = turn * direction;
  }
  const Bounds box = bounds(mesh);
  mesh = test::translated(std::move(mesh), glm::distance(box.min, box.max) * pose.offset);
  const auto model = test::model_of(mesh);
  const Assignment assignment = assign_sides(*model, {direction, {}}, {}, Progress{});
  const PartingLine line = parting_line(assignment);
  const double slack = std::max(known.slack, pose.slack) * known.outer_length * pose.scale;
  EXPECT_EQ(line.euler.loops, known.shut_offs + 1) << name;
  EXPECT_EQ(line.euler.expected_loops, known.shut_offs + 1) << name;
  EXPECT_TRUE(line.euler.accounted()) << name;
  ASSERT_FALSE(line.loops.empty()) << name;
  const PartingLoop& outer = line.loops.front();
  EXPECT_EQ(outer.kind, LoopKind::outer) << name;
  EXPECT_NEAR(outer.length, known.outer_length * pose.scale, slack) << name;
  EXPECT_NEAR(outer.climb(), known.outer_climb * pose.scale, slack) << name;
  double shut_offs = 0.0;
  for (const PartingLoop& loop : line.loops) shut_offs += loop.kind == LoopKind::shut_off ? loop.length : 0.0;
  EXPECT_NEAR(shut_offs, known.shut_off_length * pose.scale, slack * static_cast<double>(1 + known.shut_offs))
      << name;

  const MoldHalves halves = make_halves(*model, direction, {assignment.height}, {}, Progress{});
  ASSERT_TRUE(halves.made()) << name << ": " << halves.refusal;
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9) << name;
  const double cube = pose.scale * pose.scale * pose.scale;
  EXPECT_NEAR(halves.part_volume / (known.part_volume * cube), 1.0, 10.0 * pose.slack) << name;
  EXPECT_LE(halves.insert_volume, 1e-6 * halves.part_volume) << name;
  EXPECT_EQ(halves.numerical_defects(), 0U) << name;
  const WrittenMold written = written_mold(halves);
  ASSERT_EQ(written.refusal, "") << name;
  const glm::dvec3 up = written.part_frame ? halves.frame.z : glm::dvec3(0, 0, 1);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(written.bodies[k].closed) << name;
    EXPECT_LE(test::undercut_share(written.bodies[k].mesh, k == 0 ? up : -up, 0.01), 1e-6) << name;
  }
}

TEST(KnownMolds, AreWhatFormulasSay) {
  for (const KnownMold& known : known_molds()) expect_known(known, {.name = "as it is"});
}

TEST(KnownMolds, AreTheSameInEverySize) {
  for (const KnownMold& known : known_molds()) {
    for (const double scale : {1e-3, 0.37, 1e3})
      expect_known(known, {.name = fmt::format("{} times", scale), .scale = scale});
  }
}

TEST(KnownMolds, AreTheSameFarFromTheOrigin) {
  for (const KnownMold& known : known_molds()) {
    expect_known(known, {.name = "100 diagonals away", .offset = {100, -70, 30}, .slack = 1e-8});
    expect_known(known, {.name = "10,000 diagonals away", .offset = {-1e4, 3e3, 7e3}, .slack = 1e-7});
  }
}

TEST(KnownMolds, AreTheSameTurned) {
  for (const KnownMold& known : known_molds()) {
    for (const std::uint32_t seed : {3U, 8U, 21U})
      expect_known(known, {.name = fmt::format("turned by rotation {}", seed), .turn = seed, .slack = 1e-8});
    expect_known(known, {.name = "turned, small and far away",
                         .scale = 1e-3,
                         .turn = 5,
                         .offset = {300, 200, -100},
                         .slack = 1e-7});
  }
}

/// What the halves cannot form of a ring that stands upright is the disc in its hole, of a bent tube its
/// bore.
TEST(KnownMolds, LeaveToInsertsWhatFormulasSay) {
  constexpr double k_pi = std::numbers::pi;
  test::TubeShape elbow{.centres = {}, .radius = 3.0, .inner_radius = 2.0, .normal = {0, 0, 1}, .sides = 72};
  constexpr int k_sections = 48;
  for (int k = 0; k <= k_sections; ++k) {
    const double angle = 0.5 * k_pi * k / k_sections;
    elbow.centres.emplace_back(20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0);
  }
  struct Undercut {
    const char* name;
    TriangleMesh mesh;
    glm::dvec3 direction;
    double insert_volume;
  };
  const Undercut undercuts[] = {
      {"upright torus",
       test::torus_mesh(10.0, 2.0, 180, 72),
       {1, 0, 0},
       // Of the sections across the ring's axis, discs of radius 10 - sqrt(4 - z^2).
       k_pi * (400.0 - 40.0 * k_pi + 16.0 - 16.0 / 3.0)},
      {"elbow", test::tube_mesh(elbow), {0, 0, 1}, k_pi * 4.0 * 10.0 * k_pi}};
  for (const Undercut& known : undercuts) {
    for (const std::uint32_t seed : {0U, 4U}) {
      for (const double scale : {1e-3, 1e3}) {
        const std::string name = fmt::format("{}, rotation {}, {} times", known.name, seed, scale);
        const glm::dquat turn = seed == 0 ? glm::dquat(1, 0, 0, 0) : test::random_rotation(seed);
        const auto model = test::model_of(test::rotated(test::scaled(known.mesh, scale), turn));
        const glm::dvec3 d = turn * known.direction;
        const MoldHalves halves = make_halves(*model, d, {glm::dot(model->frame.center, d)}, {}, Progress{});
        ASSERT_TRUE(halves.made()) << name << ": " << halves.refusal;
        EXPECT_LE(std::abs(halves.volume_gap), 1e-9) << name;
        EXPECT_NEAR(halves.insert_volume / (known.insert_volume * scale * scale * scale), 1.0, 0.005) << name;
        const Assignment assignment = assign_sides(*model, {d, {}}, {}, Progress{});
        EXPECT_TRUE(parting_line(assignment).euler.accounted()) << name;
        EXPECT_LE(assignment.energy, assignment.energy_to_core * (1.0 + 1e-9)) << name;
        EXPECT_LE(assignment.energy, assignment.energy_to_cavity * (1.0 + 1e-9)) << name;
      }
    }
  }
}

}  // namespace
}  // namespace moldlight
