// Region areas of real parts against reference areas from exact rays, at default settings.
#include "support/reference_areas.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "gl/context.hpp"
#include "session/classifier.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr double k_region_bound = 0.005;    // of the part's area
constexpr double k_undercut_bound = 0.001;  // of the part's area, plus three standard errors of the reference
constexpr double k_least_covered = 0.95;    // share of rows whose error the stated uncertainty covers

TEST(ReferenceAreas, AreMetAtDefaultSettings) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no folder of real parts";
  const auto rows = test::read_reference_areas(*shared / "reference" / "areas.csv");
  ASSERT_GE(rows.size(), 95U);
  const auto context = gl::create_headless_context(gl::HeadlessBackend::automatic);

  struct Outcome {
    double worst_region, undercut;  // shares of the part's area
    std::string text;
  };
  std::vector<Outcome> outcomes;
  std::size_t covered = 0;
  std::string loaded;
  std::unique_ptr<Classifier> classifier;
  for (const test::ReferenceRow& row : rows) {
    if (row.part != loaded) {
      classifier = std::make_unique<Classifier>(
          *context, load_part((*shared / "parts" / row.part).string(), ReadOptions{}, Progress{}));
      loaded = row.part;
    }
    MethodSettings settings;
    settings.direction = row.direction;
    settings.tau_deg = row.tau_deg;
    settings.tolerance = row.lateral_tolerance;
    const Classification result = classifier->classify(settings, Progress{});

    EXPECT_NEAR(result.total_area, row.total, 1e-6 * row.total) << row.part;
    EXPECT_NEAR(result.near_vertical_area, row.near_vertical, 1e-4 * row.total) << row.part;
    double worst = 0.0;
    for (const Region region : k_regions) {
      worst = std::max(worst, std::abs(result.areas[region] - row.areas[region]) / row.total);
    }
    const double undercut_off = std::abs(result.areas[Region::undercut] - row.areas[Region::undercut]);
    const bool is_covered =
        undercut_off <= result.uncertainty.total + 3.0 * row.undercut_error + 5e-7 * row.total;
    covered += is_covered ? 1 : 0;
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%-34s %5.2f %5.2f %5.2f  worst region %.4f %%  undercut %+.5f %% (ref. error %.5f %%)  stated "
        "%.5f %% = %.5f sampling, %.5f audit, %.5f unsettled%s  doubtful %.2f %%  gap %+.4f %% limit %.4f %% "
        " maps %.0f measure %.0f ms",
        row.part.c_str(), row.direction.x, row.direction.y, row.direction.z, 100 * worst,
        100 * (result.areas[Region::undercut] - row.areas[Region::undercut]) / row.total,
        100 * row.undercut_error / row.total, 100 * result.uncertainty.total / row.total,
        100 * result.uncertainty.sampling / row.total, 100 * result.uncertainty.audit / row.total,
        100 * result.uncertainty.unsettled / row.total, is_covered ? "" : " NOT COVERED",
        100.0 * static_cast<double>(result.doubtful_samples) / static_cast<double>(result.samples),
        100 * result.projected.gap / row.total, 100 * result.projected.gap_limit / row.total,
        result.timings.maps_ms, result.timings.measure_ms);
    EXPECT_LE(worst, k_region_bound) << text;
    EXPECT_LE(undercut_off, k_undercut_bound * row.total + 3.0 * row.undercut_error) << text;
    outcomes.push_back({worst, undercut_off / row.total, text});
  }
  std::sort(outcomes.begin(), outcomes.end(),
            [](const Outcome& a, const Outcome& b) { return a.undercut > b.undercut; });
  std::printf("%zu rows, %zu covered by the stated uncertainty; the worst undercut areas:\n", rows.size(),
              covered);
  const std::size_t shown = std::getenv("MOLDLIGHT_ALL_ROWS") != nullptr ? outcomes.size() : 10;
  for (std::size_t i = 0; i < shown; ++i) std::printf("  %s\n", outcomes[i].text.c_str());
  EXPECT_GE(static_cast<double>(covered), k_least_covered * static_cast<double>(rows.size()));
}

}  // namespace
}  // namespace moldlight
