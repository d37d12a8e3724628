// The order of the sweep's table follows the result that is shown.
#include <algorithm>

#include <gtest/gtest.h>

#include "gui/panels/sweep_columns.hpp"

namespace moldlight::gui {
namespace {

std::shared_ptr<const SweepResult> result_of(const std::vector<double>& depths) {
  auto result = std::make_shared<SweepResult>();
  for (const double depth : depths) {
    SweepCandidate& candidate = result->candidates.emplace_back();
    candidate.rank = result->candidates.size();
    candidate.draw_depth = depth;
  }
  return result;
}

std::size_t column_of(std::string_view name) {
  const auto found = std::ranges::find(sweep_columns(), name, &SweepColumn::name);
  return static_cast<std::size_t>(found - sweep_columns().begin());
}

using Rows = std::vector<std::size_t>;

TEST(SweepOrder, IsByRankUntilAColumnIsChosen) {
  SweepOrder order;
  EXPECT_TRUE(order.follow(result_of({2, 3, 1})));
  EXPECT_EQ(order.rows(), (Rows{0, 1, 2}));
  order.sort_by(column_of("depth"));
  EXPECT_EQ(order.rows(), (Rows{2, 0, 1}));
  order.sort_by(column_of("depth"));
  EXPECT_EQ(order.rows(), (Rows{1, 0, 2}));
}

TEST(SweepOrder, StaysWhileTheResultStays) {
  SweepOrder order;
  const auto result = result_of({2, 1});
  EXPECT_TRUE(order.follow(result));
  EXPECT_FALSE(order.follow(result));
}

/// The store hands out the memory of what went: a result must not be known by its address alone.
TEST(SweepOrder, IsOfAShorterResultThatComesAfterOneThatWent) {
  SweepOrder order;
  for (int turn = 0; turn < 20; ++turn) {
    order.follow(result_of({1, 2, 3, 4, 5}));
    EXPECT_EQ(order.rows().size(), 5U);
    order.follow(result_of({2, 1}));
    ASSERT_EQ(order.rows(), (Rows{0, 1})) << turn;
  }
}

}  // namespace
}  // namespace moldlight::gui
