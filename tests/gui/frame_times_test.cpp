// moldlight view --benchmark: what it prints, without a display. And how long frames are, and how long it
// takes to a verdict and to a recommended direction, of a part that is dropped.
#include <algorithm>
#include <cstdio>
#include <ctime>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "gui/quick_options.hpp"
#include "replay/offscreen.hpp"
#include "support/process.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::gui::test {
namespace {

TEST(FrameTimes, ArePrintedWithTheirRatios) {
  const moldlight::test::SmallPart part;
  const auto result = moldlight::test::run_moldlight(
      {"view", part.file(), "--unit", "mm", "--benchmark", "--size", "320x240", "--resolution", "256"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  int facets = 0;
  double plain = 0.0, rest = 0.0, rest_ratio = 0.0, changing = 0.0, changing_ratio = 0.0, dragged = 0.0,
         dragged_ratio = 0.0;
  const std::size_t lines = result.out.find('\n') + 1;
  ASSERT_EQ(result.out[0], '#') << result.out;
  const int read =
      std::sscanf(result.out.c_str() + lines,
                  "live_plain facets=%d ms=%lf live_rest facets=%*d ms=%lf ratio=%lf live_changing "
                  "facets=%*d ms=%lf ratio=%lf figures_per_s=%*f live_dragged facets=%*d ms=%lf ratio=%lf",
                  &facets, &plain, &rest, &rest_ratio, &changing, &changing_ratio, &dragged, &dragged_ratio);
  ASSERT_EQ(read, 8) << result.out;
  EXPECT_EQ(facets, 300);
  for (const double figure : {plain, rest, rest_ratio, changing, changing_ratio, dragged, dragged_ratio})
    EXPECT_GT(figure, 0.0);
  const auto without = moldlight::test::run_moldlight({"view", "--benchmark"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_EQ(without.error_lines(), 1U) << without.err;
}

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// By processor time, which other programs on the machine change little: on two cores twice of what passes.
TEST(FrameTimes, AreShortWhileADroppedPartGetsItsVerdictAndItsRecommendation) {
  if (moldlight::test::built_with_sanitizers()) GTEST_SKIP() << "sanitizers take their time";
  OffscreenOptions options = quick_options();
  options.size = {1440, 900};
  options.user.window.quick_sweep = true;
  options.reading.unit = "mm";
  OffscreenWindow window(options);
  window.wait_until_prepared();
  const double start_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  window.drop((moldlight::test::asset_folder() / "parts" / "enclosure_lid.stl").string());  // 22,000 facets
  double longest_s = 0.0, verdict_s = 0.0, recommended_s = 0.0;
  for (int k = 0; k < 200'000 && recommended_s == 0.0; ++k) {
    const double before_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    window.frame();
    longest_s = std::max(longest_s, seconds_of(CLOCK_THREAD_CPUTIME_ID) - before_s);
    const double since_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - start_s;
    if (verdict_s == 0.0 && window.state().verdict) verdict_s = since_s;
    if (window.state().sweep.result && !window.app().sweeping()) recommended_s = since_s;
  }
  std::printf("longest frame %.3f s, verdict after %.1f s, recommendation after %.1f s of the processor\n",
              longest_s, verdict_s, recommended_s);
  EXPECT_LT(longest_s, 0.1);
  EXPECT_GT(verdict_s, 0.0);
  EXPECT_LT(verdict_s, 2.0 * 3.0);
  EXPECT_GT(recommended_s, 0.0);
}

}  // namespace
}  // namespace moldlight::gui::test
