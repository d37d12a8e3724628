// No direction of an even grid, scored by exact rays, is better than what a sweep finds.
#include <iostream>

#include <gtest/gtest.h>

#include "session/sweep/sweep.hpp"
#include "support/classify_mesh.hpp"
#include "support/grid_search.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

TEST(SweepAgainstGrid, TheGridHasNothingBetter) {
  for (const char* name : {"cable_clip.stl"}) {
    const auto model = load_part((test::asset_folder() / "parts" / name).string(), {}, Progress{});
    Classifier classifier(test::shared_context(), model);
    SweepSettings settings;
    settings.top = 1;
    const SweepResult sweep = run_sweep(classifier, settings, Progress{}, {});
    const Classification& best = sweep.candidates.front().classification;
    const test::GridBest grid = test::best_of_grid(classifier, 1000);
    EXPECT_LE(best.areas[Region::undercut], grid.undercut + grid.uncertainty + best.uncertainty.total())
        << name;
    const double share = 100.0 / best.total_area;
    std::cout << name << ": grid " << share * grid.undercut << " %, sweep "
              << share * best.areas[Region::undercut] << " %\n";
  }
}

}  // namespace
}  // namespace moldlight
