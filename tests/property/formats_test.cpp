// One part in several formats and units has the same region areas.
#include <array>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>

#include "io/mesh_writer.hpp"
#include "io/part_formats.hpp"
#include "mesh/part.hpp"
#include "support/classify_mesh.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr int k_resolution = 1024;
constexpr int k_samples = 200'000;

/// Shares of the four regions; the tolerance is a share of the part's diagonal, so that no unit matters.
std::array<double, k_region_count> shares_of(Part part, const glm::dvec3& direction) {
  Query query;
  query.direction = direction;
  query.method.resolution = k_resolution;
  query.method.samples = k_samples;
  query.method.tolerance = 1e-3 * bounds(part.mesh).diagonal();
  const auto model = prepare_part(std::move(part), Progress());
  Classifier classifier(test::shared_context(), model);
  const Classification result = classifier.classify(query, Progress());
  std::array<double, k_region_count> shares{};
  for (const Region region : k_regions)
    shares[static_cast<std::size_t>(region)] = result.areas[region] / result.total_area;
  return shares;
}

double worst_difference(const std::array<double, k_region_count>& a,
                        const std::array<double, k_region_count>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < k_region_count; ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

Part read(const std::string& path, const std::string& unit = "", const std::string& body = "all") {
  return read_part(path, {.unit = unit, .body = body}, Progress());
}

TEST(Formats, OfSharedPartsGiveTheSameRegions) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  struct Twins {
    glm::dvec3 direction;
    std::vector<std::string> files;
  };
  const std::vector<Twins> parts = {
      {{0, 0, 1},
       {"trimesh_featuretype.ply", "trimesh_featuretype.stl", "trimesh_featuretype_inch.3mf",
        "trimesh_featuretype.step"}},
      {{0, 0, 1}, {"m5_base26_main.stl", "m5_base26_main.stp"}},
      {{1, 0, 0}, {"m5_base26_main.stl", "m5_base26_main.stp"}},
      {{0, 1, 0}, {"trimesh_fixed_top.ply", "trimesh_fixed_top_bigendian.ply"}},
  };
  for (const Twins& twins : parts) {
    const auto first = shares_of(read((*shared / "parts" / twins.files[0]).string()), twins.direction);
    for (std::size_t i = 1; i < twins.files.size(); ++i) {
      if (twins.files[i].find(".st") != std::string::npos && !twins.files[i].ends_with(".stl") &&
          !MOLDLIGHT_STEP_BUILT)
        continue;
      const double worst = worst_difference(
          first, shares_of(read((*shared / "parts" / twins.files[i]).string()), twins.direction));
      std::cout << twins.files[0] << " and " << twins.files[i] << ": " << 100.0 * worst << " %\n";
      EXPECT_LT(worst, 0.005) << twins.files[i];
    }
  }
}

TEST(Formats, OfOurOwnPartsGiveTheSameRegions) {
  const test::ScratchFolder folder;
  const test::Shape shape = test::cup_with_side_hole({});
  const std::vector<Region> regions(shape.mesh.facets.size(), Region::core);
  std::array<double, k_region_count> first{};
  for (const char* name : {"part.ply", "part.obj", "part.stl"}) {
    write_coloured_mesh(folder.file(name), {.mesh = shape.mesh, .regions = regions});
    const auto shares = shares_of(read(folder.file(name)), shape.direction);
    if (std::string(name) == "part.ply") first = shares;
    // Coordinates of an STL are in single precision.
    EXPECT_LE(worst_difference(first, shares), std::string(name) == "part.stl" ? 1e-4 : 0.0) << name;
  }
}

TEST(Formats, UnitsChangeNoShare) {
  const test::ScratchFolder folder;
  const test::Shape shape = test::snap_hook({});
  TriangleMesh metres = shape.mesh;
  for (glm::dvec3& vertex : metres.vertices) vertex *= 0.001;
  const std::vector<Region> regions(shape.mesh.facets.size(), Region::core);
  write_coloured_mesh(folder.file("mm.ply"), {.mesh = shape.mesh, .regions = regions});
  write_coloured_mesh(folder.file("m.ply"), {.mesh = metres, .regions = regions});
  const auto mm = shares_of(read(folder.file("mm.ply"), "mm"), shape.direction);
  EXPECT_LE(worst_difference(mm, shares_of(read(folder.file("m.ply"), "m"), shape.direction)), 1e-4);
  Part converted = read(folder.file("m.ply"), "m");
  set_unit(converted, "mm");
  EXPECT_NEAR(bounds(converted.mesh).diagonal(), bounds(shape.mesh).diagonal(), 1e-9);
  EXPECT_LE(worst_difference(mm, shares_of(converted, shape.direction)), 1e-4);
}

TEST(Formats, BodiesAreClassifiedAloneOrTogether) {
  if (!MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without STEP support";
  const std::string path = (test::data_folder() / "pin_and_block_inch.step").string();
  // The upright pin and the block hide nothing from each other along z; along x the block hides half of the
  // pin's side.
  const auto block = shares_of(read(path, "", "block"), {1, 0, 0});
  EXPECT_NEAR(block[3], 0.0, 1e-3);
  const auto both = shares_of(read(path), {1, 0, 0});
  EXPECT_GT(both[3], 0.05);
  EXPECT_NEAR(shares_of(read(path), {0, 0, 1})[3], 0.0, 1e-3);
}

}  // namespace
}  // namespace moldlight
