// The split mesh of shapes and real parts: conforming, inside its facets, labelled as rays say; and the
// borders in it.
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "classify/part_model.hpp"
#include "mesh/health.hpp"
#include "support/box_pile.hpp"
#include "support/exact_model.hpp"
#include "support/manifest.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"
#include "support/split_checks.hpp"

namespace moldlight {
namespace {

/// Of rays too close to an edge to call: more would mean that they test little.
constexpr double k_most_unclear = 0.02;

constexpr double k_identity = 1e-10;   // of the area
constexpr double k_most_doubt = 1e-6;  // walls tilted by the rounding of files in single precision
/// Has facets that lie double in one plane: both are surface, and seen.
constexpr const char* k_partly_double = "3mf_cube_gears_17parts.3mf";
constexpr double k_identity_of_double = 1e-6;

struct SplitTotals {
  std::size_t splits = 0, closed = 0, facets = 0, pieces = 0, rays = 0, unclear = 0, borders = 0;
  double worst_ratio = 0.0;  // pieces over facets
  void print() const {
    std::printf(
        "%zu splits, %zu of closed parts: %zu facets in %zu pieces (at most %.2f times), %zu rays, %zu "
        "too close to call, %zu borders\n",
        splits, closed, facets, pieces, worst_ratio, rays, unclear, borders);
  }
};

void check_split(const test::ExactModel& model, const glm::dvec3& direction,
                 const test::ShapeSettings& settings, std::size_t rays, const std::string& part,
                 SplitTotals& totals) {
  char name[200];
  std::snprintf(name, sizeof name, "%s along (%.3g, %.3g, %.3g)", part.c_str(), direction.x, direction.y,
                direction.z);
  const ExactAreas areas = model.areas(direction, settings);
  const ExactSplit split = model.split(direction, settings);
  EXPECT_EQ(areas.facet_fractions, split.areas.facet_fractions) << name;
  EXPECT_EQ(areas.areas.values, split.areas.areas.values) << name;
  EXPECT_EQ(areas.projected_core, split.areas.projected_core) << name;
  EXPECT_EQ(areas.projected_cavity, split.areas.projected_cavity) << name;
  test::expect_sound_split(model, split, name);
  test::expect_whole_borders(split.mesh, name);
  const bool closed = health_report(model.mesh(), model.geometry()).closed;
  if (closed) {
    const double bound = part == k_partly_double ? k_identity_of_double : k_identity;
    EXPECT_NEAR(areas.projected_core, areas.projected_cavity,
                areas.projected_doubt + bound * areas.areas.total())
        << name;
    EXPECT_LE(areas.projected_doubt, k_most_doubt * areas.areas.total()) << name;
  }

  const test::RayVerdicts verdicts =
      test::ray_verdicts(model, split.mesh, glm::normalize(direction), settings, rays,
                         1 + static_cast<std::uint32_t>(totals.splits));
  EXPECT_EQ(verdicts.wrong.size(), 0U) << name;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, verdicts.wrong.size()); ++i)
    ADD_FAILURE() << name << ": " << verdicts.wrong[i];

  ++totals.splits;
  totals.closed += closed ? 1 : 0;
  totals.facets += model.mesh().facets.size();
  totals.pieces += split.mesh.pieces.size();
  totals.worst_ratio = std::max(totals.worst_ratio, static_cast<double>(split.mesh.pieces.size()) /
                                                        static_cast<double>(model.mesh().facets.size()));
  totals.rays += verdicts.pieces;
  totals.unclear += verdicts.unclear;
  totals.borders += region_borders(split.mesh).size();
}

TEST(ExactSplit, OfOurOwnShapesIsSound) {
  SplitTotals totals;
  for (const test::Shape& shape : test::all_shapes({})) {
    const test::ExactModel model(shape.mesh);
    check_split(model, shape.direction, shape.settings, 2000, shape.name, totals);
    for (const glm::dvec3& direction : {glm::dvec3(0.36, 0.48, 0.8), glm::dvec3(1, 0, 0)})
      check_split(model, direction, shape.settings, 1000, shape.name, totals);
  }
  totals.print();
  EXPECT_LE(static_cast<double>(totals.unclear), k_most_unclear * static_cast<double>(totals.rays));
}

TEST(ExactSplit, OfPilesIsSound) {
  SplitTotals totals;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const test::BoxPile pile = test::random_pile(seed, seed % 4 == 3);
    const glm::dquat rotation = seed % 3 == 0 ? glm::dquat(1, 0, 0, 0) : test::random_rotation(seed);
    TriangleMesh mesh = test::rotated(test::pile_mesh(pile, seed), rotation);
    if (seed % 2 == 1) mesh = test::rounded_to_float(mesh);
    const test::ExactModel model(mesh);
    const test::ShapeSettings settings{.tau_deg = seed % 5 == 0 ? 30.0 : 1.0,
                                       .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)};
    for (const glm::dvec3& direction : test::five_directions())
      check_split(model, rotation * direction, settings, 300, "pile " + std::to_string(seed), totals);
  }
  totals.print();
  EXPECT_LE(static_cast<double>(totals.unclear), k_most_unclear * static_cast<double>(totals.rays));
}

void check_part(const std::string& path, const std::string& name, SplitTotals& totals) {
  const auto part = load_part(path, ReadOptions{}, Progress{});
  const test::ExactModel model(part->part.mesh);
  for (const glm::dvec3& direction : test::five_directions())
    check_split(model, direction, model.default_settings(), 10'000, name, totals);
}

TEST(ExactSplit, OfShippedPartsIsSound) {
  SplitTotals totals;
  for (const char* name : {"bottle_cap.stl", "cable_clip.stl", "enclosure_lid.stl", "tilted_bracket.stl"})
    check_part((test::asset_folder() / "parts" / name).string(), name, totals);
  totals.print();
  EXPECT_EQ(totals.closed, totals.splits);
  EXPECT_LE(static_cast<double>(totals.unclear), k_most_unclear * static_cast<double>(totals.rays));
}

TEST(ExactSplit, OfSharedPartsIsSound) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no folder of real parts";
  SplitTotals totals;
  std::size_t parts = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (row.file.starts_with("bad/")) continue;
    try {
      check_part((*shared / "parts" / row.file).string(), row.file, totals);
      ++parts;
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("not supported"), std::string::npos) << error.what();
    }
  }
  std::printf("%zu shared parts: ", parts);
  totals.print();
  EXPECT_GE(parts, 38U);
  EXPECT_LE(static_cast<double>(totals.unclear), k_most_unclear * static_cast<double>(totals.rays));
}

TEST(RegionBorders, MeetWhereFourRegionsDo) {
  // A square of four triangles round its middle: core, cavity, both, undercut.
  SplitMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  mesh.pieces = {{{0, 1, 4}, 0, Region::core},
                 {{1, 2, 4}, 0, Region::cavity},
                 {{2, 3, 4}, 0, Region::both},
                 {{3, 0, 4}, 0, Region::undercut}};
  const std::vector<RegionBorder> borders = region_borders(mesh);
  ASSERT_EQ(borders.size(), 4U);
  std::map<std::pair<Region, Region>, std::vector<VertexIndex>> found;
  for (const RegionBorder& border : borders) {
    EXPECT_FALSE(border.closed());
    found[{border.left, border.right}] = border.vertices;
  }
  const auto line = [&](Region left, Region right) { return found[{left, right}]; };
  EXPECT_EQ(line(Region::core, Region::cavity), (std::vector<VertexIndex>{1, 4}));
  EXPECT_EQ(line(Region::cavity, Region::both), (std::vector<VertexIndex>{2, 4}));
  EXPECT_EQ(line(Region::both, Region::undercut), (std::vector<VertexIndex>{3, 4}));
  EXPECT_EQ(line(Region::core, Region::undercut), (std::vector<VertexIndex>{4, 0}));
  test::expect_whole_borders(mesh, "square");
}

TEST(RegionBorders, AroundAPatchIsClosed) {
  // A tetrahedron with one facet of another region.
  SplitMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.pieces = {{{0, 2, 1}, 0, Region::undercut},
                 {{0, 1, 3}, 1, Region::cavity},
                 {{1, 2, 3}, 2, Region::cavity},
                 {{2, 0, 3}, 3, Region::cavity}};
  const std::vector<RegionBorder> borders = region_borders(mesh);
  ASSERT_EQ(borders.size(), 1U);
  EXPECT_TRUE(borders[0].closed());
  EXPECT_EQ(borders[0].left, Region::cavity);
  EXPECT_EQ(borders[0].right, Region::undercut);
  EXPECT_EQ(borders[0].vertices.size(), 4U);
  // With the cavity on the left: against the sense in which the undercut facet runs through it.
  const auto& walk = borders[0].vertices;
  const auto at = static_cast<std::size_t>(std::find(walk.begin(), walk.end() - 1, 0U) - walk.begin());
  EXPECT_EQ(walk[(at + 1) % 3], 1U);
  test::expect_whole_borders(mesh, "tetrahedron");
}

TEST(RegionBorders, WithoutPiecesOrWithOneRegionAreNone) {
  EXPECT_TRUE(region_borders(SplitMesh{}).empty());
  SplitMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.pieces = {{{0, 2, 1}, 0, Region::core}, {{0, 1, 3}, 1, Region::core}};
  EXPECT_TRUE(region_borders(mesh).empty());
}

}  // namespace
}  // namespace moldlight
