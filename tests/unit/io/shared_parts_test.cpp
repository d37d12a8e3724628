#include "support/shared_parts.hpp"

#include <ctime>
#include <iostream>
#include <set>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.hpp"
#include "io/part_formats.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "support/manifest.hpp"

namespace moldlight {
namespace {

bool is_bad(const test::ManifestRow& row) { return row.file.starts_with("bad/"); }

bool has_own_facets(const test::ManifestRow& row) { return row.format != "STEP"; }

std::string part_path(const test::ManifestRow& row) {
  return (*test::shared_folder() / "parts" / row.file).string();
}

TEST(SharedParts, HaveTheFacetsOfTheManifest) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  std::size_t used = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (is_bad(row) || !has_own_facets(row)) continue;
    const Part part = read_part(part_path(row), {}, Progress());
    EXPECT_EQ(part.mesh.facets.size(), row.facets) << row.file;
    FacetIndex covered = 0;
    for (const Body& body : part.bodies) {
      EXPECT_EQ(body.first_facet, covered) << row.file;
      covered += body.facet_count;
    }
    EXPECT_EQ(covered, part.mesh.facets.size()) << row.file;
    EXPECT_TRUE(part.facet_source.empty() || part.facet_source.size() == covered) << row.file;
    ++used;
  }
  std::cout << used << " shared parts read\n";
  EXPECT_GE(used, 40u);
}

double area_of(const std::string& name) {
  const Part part = read_part((*test::shared_folder() / "parts" / name).string(), {}, Progress());
  return facet_geometry(part.mesh).total_area;
}

/// STEP files have no facets of their own; theirs make a closed surface with the area of the same part in
/// STL.
TEST(SharedParts, AreTheSameInStepAsInStl) {
  if (!test::shared_folder() || !MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "no shared parts, or no STEP support";
  std::size_t used = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (has_own_facets(row)) continue;
    const Part part = read_part(part_path(row), {}, Progress());
    const HealthReport health = health_report(part.mesh, facet_geometry(part.mesh));
    EXPECT_TRUE(health.closed) << row.file;
    EXPECT_EQ(health.components, 1u) << row.file;
    EXPECT_GT(health.facets, 10'000u) << row.file;
    EXPECT_TRUE(part.warnings.empty()) << row.file << ": " << part.warnings.front();
    ++used;
  }
  EXPECT_EQ(used, 3u);
  for (const char* name : {"m5_base26_main", "trimesh_featuretype"}) {
    const std::string step = std::string(name) + (name[0] == 'm' ? ".stp" : ".step");
    const double area = area_of(std::string(name) + ".stl");
    EXPECT_NEAR(area_of(step) / area, 1.0, 2.5e-4) << name;
  }
}

HealthReport health_of(const Part& part) { return health_report(part.mesh, facet_geometry(part.mesh)); }

TEST(SharedParts, AreClosedByRepair) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  const auto read = [](const std::string& name, RepairLevel level) {
    ReadOptions options;
    options.repair.level = level;
    return read_part((*test::shared_folder() / "parts" / name).string(), options, Progress());
  };
  for (const char* name :
       {"trimesh_featuretype.stl", "trimesh_angle_block_open.stl", "trimesh_octagonal_pocket_metres.ply"}) {
    const Part open = read(name, RepairLevel::none);
    const Part welded = read(name, RepairLevel::weld);
    EXPECT_FALSE(health_of(open).closed) << name;
    EXPECT_TRUE(health_of(welded).closed) << name;
    EXPECT_EQ(open.mesh.facets.size(), welded.mesh.facets.size()) << name;
    EXPECT_NEAR(health_of(welded).area / health_of(open).area, 1.0, 1e-6) << name;
  }
  for (const char* name : {"trimesh_featuretype_inch.3mf", "m5_basic27_bottom_shell_open.obj",
                           "m5_button_half_flipped.stl", "trimesh_multibody_flipped.stl"}) {
    EXPECT_TRUE(health_of(read(name, RepairLevel::full)).closed) << name;
  }
  std::size_t whole = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (row.file.starts_with("bad/") || row.format == "STEP") continue;
    const Part before = read(row.file, RepairLevel::none), after = read(row.file, RepairLevel::full);
    EXPECT_NEAR(health_of(after).area / health_of(before).area, 1.0, 2e-4) << row.file;
    EXPECT_GE(health_of(after).closed, health_of(before).closed) << row.file;
    EXPECT_EQ(health_of(after).degenerate_facets, 0u) << row.file;
    whole += health_of(after).closed ? 1 : 0;
  }
  std::cout << whole << " shared parts are closed after a full repair\n";
}

/// Files that are merely poor are read; every other bad file ends in one line that names it.
TEST(SharedParts, EndCleanlyWhereTheyAreBad) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  const std::set<std::string> poor = {"bad/all_degenerate.stl", "bad/openscad_zero_area.stl"};
  std::size_t used = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (!is_bad(row)) continue;
    const std::clock_t start = std::clock();
    const std::string path = part_path(row);
    try {
      const Part part = read_part(path, {}, Progress());
      EXPECT_TRUE(poor.contains(row.file)) << row.file;
      EXPECT_EQ(part.mesh.facets.size(), row.facets) << row.file;
    } catch (const FileError& error) {
      const std::string text = error.what();
      EXPECT_FALSE(poor.contains(row.file)) << text;
      EXPECT_TRUE(text.starts_with(path + ": ")) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      std::cout << text.substr(path.size() - row.file.size()) << '\n';
    }
    EXPECT_LT(std::clock() - start, 5 * CLOCKS_PER_SEC) << row.file << ", of the processor";
    ++used;
  }
  std::cout << used << " bad files tried\n";
  EXPECT_GE(used, 20u);
}

}  // namespace
}  // namespace moldlight
