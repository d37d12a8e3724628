// Areas and errors from counted samples.
#include "mold/sweep/sample_counts.hpp"

#include <gtest/gtest.h>

namespace moldlight {
namespace {

TEST(SampleCounts, StrataOfOneKindAddNoSpread) {
  SampleCounts counts;
  counts.add_stratum({16, 0, 0, 0});
  counts.add_stratum({0, 0, 0, 16});
  counts.add_stratum({0, 0, 0, 0});
  EXPECT_EQ(counts.spread, 0U);
  EXPECT_EQ(counts.total(), 32U);
  EXPECT_DOUBLE_EQ(counts.areas(8.0)[Region::core], 4.0);
  EXPECT_DOUBLE_EQ(counts.areas(8.0)[Region::undercut], 4.0);
  EXPECT_DOUBLE_EQ(counts.undercut_error(8.0), 8.0 * 2.0 / 32.0) << "one sample more of either kind";
}

TEST(SampleCounts, ErrorGrowsWithMixedStrataAndDoubt) {
  SampleCounts mixed;
  mixed.add_stratum({0, 8, 0, 8});
  EXPECT_EQ(mixed.spread, 64U);
  SampleCounts few;
  few.add_stratum({1, 0, 0, 2});
  EXPECT_EQ(few.spread, 11U) << "16 * 2 * 1 / 3, rounded up";
  few.add(mixed);
  EXPECT_EQ(few.spread, 75U);
  EXPECT_EQ(few.total(), 19U);
  const double sure = few.undercut_error(1.0);
  few.undercut_in_doubt = 5;
  EXPECT_GT(few.undercut_error(1.0), sure);
}

TEST(SampleCounts, NothingCountedSaysNothing) {
  EXPECT_EQ(SampleCounts{}.areas(3.0).total(), 0.0);
  EXPECT_EQ(SampleCounts{}.undercut_error(3.0), 3.0);
}

}  // namespace
}  // namespace moldlight
