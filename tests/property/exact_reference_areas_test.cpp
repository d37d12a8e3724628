// Exact region areas of real parts against reference areas from other programs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

#include "classify/part_model.hpp"
#include "support/exact_model.hpp"
#include "support/reference_areas.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr double k_bound = 1e-6;       // of the part's area
constexpr double k_open_bound = 2e-5;  // where the part is open

TEST(ReferenceAreas, AreMetByExactRegions) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no folder of real parts";
  const auto rows = test::read_reference_areas(*shared / "reference" / "areas.csv");
  ASSERT_GE(rows.size(), 95U);
  struct Outcome {
    double worst;  // share of the part's area
    std::string text;
  };
  std::vector<Outcome> outcomes;
  std::string loaded;
  bool closed = false;
  std::unique_ptr<test::ExactModel> model;
  for (const test::ReferenceRow& row : rows) {
    if (row.part != loaded) {
      const auto part = load_part((*shared / "parts" / row.part).string(), ReadOptions{}, Progress{});
      closed = part->health.closed;
      model = std::make_unique<test::ExactModel>(part->part.mesh);
      loaded = row.part;
    }
    const ExactAreas found =
        model->areas(row.direction, {.tau_deg = row.tau_deg, .lateral_tolerance = row.lateral_tolerance});
    EXPECT_NEAR(found.areas.total(), row.total, 1e-8 * row.total) << row.part;
    EXPECT_NEAR(found.near_vertical_area, row.near_vertical, 1e-6 * row.total) << row.part;
    const double worst = test::largest_difference(found.areas, row.areas) / row.total;
    char text[300];
    std::snprintf(text, sizeof text,
                  "%-34s %5.2f %5.2f %5.2f  worst region %.2e: core %+.1e cavity %+.1e both %+.1e undercut "
                  "%+.1e, shadow %+.1e",
                  row.part.c_str(), row.direction.x, row.direction.y, row.direction.z, worst,
                  (found.areas[Region::core] - row.areas[Region::core]) / row.total,
                  (found.areas[Region::cavity] - row.areas[Region::cavity]) / row.total,
                  (found.areas[Region::both] - row.areas[Region::both]) / row.total,
                  (found.areas[Region::undercut] - row.areas[Region::undercut]) / row.total,
                  (found.projected_core - found.projected_cavity) / row.total);
    EXPECT_LE(worst, closed ? k_bound : k_open_bound) << text;
    outcomes.push_back({worst, text});
  }
  std::sort(outcomes.begin(), outcomes.end(),
            [](const Outcome& a, const Outcome& b) { return a.worst > b.worst; });
  std::printf("%zu rows; the worst:\n", rows.size());
  const std::size_t shown = std::getenv("MOLDLIGHT_ALL_ROWS") != nullptr ? outcomes.size() : 8;
  for (std::size_t i = 0; i < shown; ++i) std::printf("  %s\n", outcomes[i].text.c_str());
}

}  // namespace
}  // namespace moldlight
