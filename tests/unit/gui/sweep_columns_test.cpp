// What the columns of the sweep's table say.
#include "gui/panels/sweep_columns.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace moldlight::gui {
namespace {

std::string text_of(std::string_view column, const SweepCandidate& candidate) {
  const auto found = std::ranges::find(sweep_columns(), column, &SweepColumn::name);
  return found->text(AppState{}, candidate);
}

/// Exact figures are off by rounding alone, which the digits of an area do not show.
TEST(SweepColumns, SayHowLittleExactFiguresMayBeOff) {
  SweepCandidate candidate;
  candidate.classification.uncertainty.rounding = 1.49e-5;
  EXPECT_EQ(text_of("±", candidate), "1.5e-05");
  candidate.classification.uncertainty = {.rounding = 0.0, .mesh = 12.3};
  EXPECT_EQ(text_of("±", candidate), "12");
  candidate.classification.uncertainty = {};
  EXPECT_EQ(text_of("±", candidate), "0");
}

}  // namespace
}  // namespace moldlight::gui
