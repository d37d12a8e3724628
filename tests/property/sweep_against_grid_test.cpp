// The first direction of a default sweep is the best by exact areas, near it and anywhere.
#include <iostream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/map_frame.hpp"
#include "support/classify_mesh.hpp"
#include "support/grid_search.hpp"
#include "support/shared_parts.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/scoring.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

constexpr double k_allowed_share = 5e-5;  // of the part's area
constexpr std::size_t k_even_directions = 1000;
constexpr std::uintmax_t k_most_grid_bytes = 4'000'000;

/// 16 directions on each of 8 rings from 0.05 to 2.5 degrees.
std::vector<ScoringTask> tasks_around(const glm::dvec3& direction, double give_up_above) {
  std::vector<ScoringTask> tasks;
  for (int ring = 0; ring < 8; ++ring) {
    const double angle_deg = 0.05 * std::pow(50.0, ring / 7.0);
    for (const glm::dvec3& probe : ring_around(direction, angle_deg, 16, 5.0 * ring))
      tasks.push_back({probe, give_up_above});
  }
  return tasks;
}

void expect_nothing_better(const std::filesystem::path& file) {
  const auto model = load_part(file.string(), {}, Progress{});
  if (!model->health.closed) return;
  SweepSettings settings;
  settings.rank = SweepRank::objective;
  settings.top = 3;
  const SweepResult sweep = run_sweep(model, settings, Progress{}, {});
  const Classification& best = sweep.candidates.front().classification;
  const double total = model->geometry.total_area, found = best.areas[Region::undercut];
  const double allowed = found - k_allowed_share * total;
  double near = found;
  if (allowed > 0.0) {
    DirectionMeasurer measurer(*model, settings.method, ScoringPool::threads(0));
    const auto around =
        measurer.measure(tasks_around(best.direction, allowed), {}, Progress{}, [] { return false; });
    for (const auto& measured : around) {
      if (measured) near = std::min(near, measured->classification.areas[Region::undercut]);
    }
  }
  EXPECT_GE(near, allowed) << file;
  const test::GridBest grid = test::best_of_grid(*model, k_even_directions);
  EXPECT_GE(grid.undercut, allowed) << file << ": " << grid.direction.x << ", " << grid.direction.y << ", "
                                    << grid.direction.z;
  const double share = 100.0 / total;
  std::cout << file.filename().string() << ": sweep " << share * found << " %, around it " << share * near
            << " %, of the even ones " << share * grid.undercut << " %\n";
}

TEST(SweepAgainstGrid, NothingIsBetterThanTheBestOfTheShippedParts) {
  for (const char* name : {"bottle_cap.stl", "cable_clip.stl", "enclosure_lid.stl", "tilted_bracket.stl"})
    expect_nothing_better(test::asset_folder() / "parts" / name);
}

TEST(SweepAgainstGrid, NothingIsBetterThanTheBestOfTheSharedParts) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  std::size_t parts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*test::shared_folder() / "parts")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".stl" && extension != ".obj" && extension != ".ply" && extension != ".off") continue;
    if (entry.file_size() > k_most_grid_bytes) continue;
    SCOPED_TRACE(entry.path().string());
    expect_nothing_better(entry.path());
    ++parts;
  }
  std::cout << parts << " shared parts\n";
}

}  // namespace
}  // namespace moldlight
