// The order of the sweep's table: by rank, or by a figure.
#include <gtest/gtest.h>

#include "gui/panels/workspace.hpp"

namespace moldlight::gui {
namespace {

using Rows = std::vector<std::size_t>;

TEST(SweepOrder, IsByRankOrByAFigure) {
  SweepResult result;
  for (const std::optional<double> depth : {std::optional(2.0), std::optional(3.0), {}, std::optional(2.0)}) {
    SweepCandidate& candidate = result.candidates.emplace_back();
    candidate.rank = result.candidates.size();
    for (const DirectionFigure& row : direction_figures())
      candidate.figures.push_back(row.key == "draw_depth" ? depth : 0.0);
  }
  const DirectionFigure& depth = direction_figure("draw_depth");
  EXPECT_EQ(sorted_candidates(result, nullptr, false), (Rows{0, 1, 2, 3}));
  EXPECT_EQ(sorted_candidates(result, nullptr, true), (Rows{3, 2, 1, 0}));
  EXPECT_EQ(sorted_candidates(result, &depth, false), (Rows{2, 0, 3, 1})) << "what is not known is first";
  EXPECT_EQ(sorted_candidates(result, &depth, true), (Rows{1, 0, 3, 2}));
}

}  // namespace
}  // namespace moldlight::gui
