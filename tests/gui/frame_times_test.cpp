// moldlight view --benchmark: what it prints, without a display.
#include <cstdio>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"

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

}  // namespace
}  // namespace moldlight::gui::test
