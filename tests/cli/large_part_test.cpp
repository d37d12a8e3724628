// Two million facets, and hundreds of bodies in each other: the memory is bounded.
#include <cstdio>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/boxes.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

constexpr std::size_t k_facets = 2'000'000;
constexpr std::size_t k_memory_limit = std::size_t{2} << 30;

TEST(LargePart, OfTwoMillionFacetsTakesLessThanTwoGigabytes) {
  if (test::built_with_sanitizers()) GTEST_SKIP() << "the sanitizers take memory of their own";
  const test::ScratchFolder folder;
  const std::string file = folder.file("large.stl");
  {
    const TriangleMesh mesh =
        test::subdivided(test::cup_with_side_hole(test::ShapeSettings{}).mesh, k_facets);
    const std::vector<Region> regions(mesh.facets.size(), Region::core);
    write_coloured_mesh(file, {mesh, regions});
  }
  test::ProcessSettings settings;
  settings.time_limit_s = 300.0;
  const auto run = test::run_moldlight({"classify", file, "--direction", "0,0,1", "--json", "-"}, settings);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = test::json_of(run.out);
  EXPECT_GE(json["part"]["facets"], k_facets - 1);
  EXPECT_LT(run.peak_memory, k_memory_limit);
  const auto& timings = json["timings_ms"];
  std::printf("%zu facets: %.1f s of the processor (load %.1f s, regions %.1f s), peak memory %.2f GiB\n",
              json["part"]["facets"].get<std::size_t>(), run.processor_s,
              timings["load"].get<double>() / 1000.0, timings["regions"].get<double>() / 1000.0,
              static_cast<double>(run.peak_memory) / static_cast<double>(std::size_t{1} << 30));
}

/// Side actions of a heap of boxes: hundreds of bodies are tried.
TEST(LargePart, SideActionsOfFourHundredBoxesTakeTwoHundredMegabytesAndTwoKilobytesAFacet) {
  if (test::built_with_sanitizers()) GTEST_SKIP() << "the sanitizers take memory of their own";
  const test::ScratchFolder folder;
  test::Random random(9);
  TriangleMesh heap;
  for (int k = 0; k < 400; ++k) {
    const glm::dvec3 low = random.in_cube(5.0), size = glm::dvec3(1.6) + random.in_cube(1.4);
    heap = test::joined(heap, test::box_mesh(low, low + size));
  }
  const std::string file = folder.file("heap.stl");
  write_coloured_mesh(file, {heap, std::vector<Region>(heap.facets.size(), Region::core)});
  test::ProcessSettings settings;
  settings.time_limit_s = 300.0;
  const auto run = test::run_moldlight({"actions", file, "--direction", "z"}, settings);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(run.peak_memory, (std::size_t{200} << 20) + 2048 * heap.facets.size());
}

/// Loose facets that lie over each other are cut into dozens of pieces each: what asks for lines between them
/// refuses, and says so.
TEST(LargePart, LooseFacetsInOnePlaneTakeTwoHundredMegabytesAndTwoKilobytesAFacet) {
  if (test::built_with_sanitizers()) GTEST_SKIP() << "the sanitizers take memory of their own";
  constexpr std::size_t k_loose = 30'000;
  const test::ScratchFolder folder;
  test::Random random(4);
  TriangleMesh loose;
  for (std::size_t k = 0; k < k_loose; ++k) {
    const glm::dvec3 at = random.in_cube(50.0);
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 off = random.in_cube(1.0);
      loose.vertices.push_back({at.x + off.x, at.y + off.y, 0.0});
    }
    const auto first = static_cast<VertexIndex>(3 * k);
    loose.facets.push_back({first, first + 1, first + 2});
  }
  const std::string file = folder.file("loose.stl");
  write_coloured_mesh(file, {loose, std::vector<Region>(k_loose, Region::core)});
  const std::size_t most = (std::size_t{200} << 20) + 2048 * k_loose;
  for (const char* command : {"classify", "actions", "mold"}) {
    const bool refuses = command == std::string("mold");
    const auto run = test::run_moldlight({command, file, "--direction", "0.1,0.5,-0.9"});
    EXPECT_EQ(run.exit_code, refuses ? 1 : 0) << run.err;
    const bool says_why = run.err.find("too many of its facets cross others") != std::string::npos;
    EXPECT_EQ(says_why, refuses) << run.err;
    EXPECT_LT(run.peak_memory, most) << command;
    std::printf("%s: %.0f MiB\n", command, static_cast<double>(run.peak_memory) / (1 << 20));
  }
}

}  // namespace
}  // namespace moldlight
