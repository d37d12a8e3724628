// Areas and errors from counted samples.
#include <cmath>

#include <gtest/gtest.h>

#include "mold/measure.hpp"

namespace moldlight {
namespace {

TEST(SampleCounts, AreasAreSharesOfTheSamples) {
  SampleCounts counts{.regions = {16, 0, 0, 10}};
  counts.add({.regions = {0, 4, 2, 0}});
  EXPECT_EQ(counts.total(), 32U);
  EXPECT_DOUBLE_EQ(counts.areas(8.0)[Region::core], 4.0);
  EXPECT_DOUBLE_EQ(counts.areas(8.0)[Region::cavity], 1.0);
  EXPECT_DOUBLE_EQ(counts.areas(8.0)[Region::undercut], 2.5);
}

TEST(SampleCounts, TheErrorIsThatOfIndependentSamplesWithOneMoreOfEitherKind) {
  const SampleCounts none{.regions = {98, 0, 0, 0}};
  EXPECT_DOUBLE_EQ(none.undercut(8.0).area, 8.0 * 0.01);
  EXPECT_DOUBLE_EQ(none.undercut(8.0).error, 8.0 * std::sqrt(0.01 * 0.99 / 100.0));
  const SampleCounts half{.regions = {0, 49, 0, 49}};
  EXPECT_DOUBLE_EQ(half.undercut(8.0).area, 4.0);
  EXPECT_DOUBLE_EQ(half.undercut(8.0).error, 8.0 * 0.05);
}

TEST(SampleCounts, NothingCountedSaysNothing) {
  EXPECT_EQ(SampleCounts{}.areas(3.0).total(), 0.0);
  EXPECT_GT(SampleCounts{}.undercut(3.0).error, 1.0);
}

}  // namespace
}  // namespace moldlight
