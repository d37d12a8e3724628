#include "sweep/ranking.hpp"

#include <gtest/gtest.h>

namespace moldlight {
namespace {

constexpr PartMeasure k_part{.area = 100.0, .diagonal = 10.0};

struct Given {
  double undercut = 0.0, uncertainty = 0.0, undercuts = 0.0, depth = 1.0, projected = 1.0;
  bool exact = false;
  double actions = 0.0, travel = 0.0;
  bool decided = true;
};

/// By the undercut, or by another value.
Ranking ranked(
    const std::vector<Given>& given,
    double (*value)(const Given&) = [](const Given& one) { return one.undercut / k_part.area; }) {
  std::vector<RankedFigures> figures;
  for (const Given& one : given) {
    figures.push_back({.value = value(one),
                       .value_uncertainty = one.uncertainty / k_part.area,
                       .undercut = one.undercut,
                       .undercut_uncertainty = one.uncertainty,
                       .undercuts = one.undercuts,
                       .draw_depth = one.depth,
                       .projected_area = one.projected,
                       .actions = one.actions,
                       .travel = one.travel,
                       .decided = one.decided,
                       .exact = one.exact});
  }
  return rank_directions(figures, k_part);
}

using Numbers = std::vector<std::size_t>;

TEST(Ranking, PutsTheLeastUndercutFirst) {
  const Ranking ranking = ranked({{.undercut = 3.0}, {.undercut = 1.0}, {.undercut = 2.0}});
  EXPECT_EQ(ranking.order, (Numbers{1, 2, 0}));
  EXPECT_EQ(ranking.tie_group, (Numbers{2, 0, 1}));
}

TEST(Ranking, TiesByTheUncertaintiesOfBoth) {
  const auto groups = [](double best, double other) {
    return ranked({{.undercut = 1.0, .uncertainty = best}, {.undercut = 2.0, .uncertainty = other}})
        .tie_group;
  };
  EXPECT_EQ(groups(0.7, 0.0), (Numbers{0, 1}));
  EXPECT_EQ(groups(0.0, 0.7), (Numbers{0, 1}));
  EXPECT_EQ(groups(0.4, 0.5), (Numbers{0, 1}));
  EXPECT_EQ(groups(0.5, 0.6), (Numbers{0, 0}));
  EXPECT_EQ(groups(1.1, 0.0), (Numbers{0, 0}));
  EXPECT_EQ(groups(0.0, 1.1), (Numbers{0, 0}));
}

TEST(Ranking, GathersATieAcrossWhatLiesBetween) {
  const Ranking ranking =
      ranked({{.undercut = 1.0}, {.undercut = 2.0}, {.undercut = 3.0, .uncertainty = 2.5}});
  EXPECT_EQ(ranking.order, (Numbers{0, 2, 1}));
  EXPECT_EQ(ranking.tie_group, (Numbers{0, 1, 0}));
}

TEST(Ranking, OrdersATieByFeaturesThenDepthThenShadow) {
  EXPECT_EQ(ranked({{.depth = 1.0}, {.depth = 9.0, .exact = true}}).order, (Numbers{1, 0}));
  EXPECT_EQ(ranked({{.depth = 2.0, .projected = 1.0}, {.depth = 1.0, .projected = 2.0}}).order,
            (Numbers{1, 0}));
  EXPECT_EQ(ranked({{.projected = 2.0}, {.projected = 1.0}}).order, (Numbers{1, 0}));
  EXPECT_EQ(ranked({{}, {}}).order, (Numbers{0, 1}));
}

/// A tie in area is decided by what it takes to make the mold, before all else.
TEST(Ranking, OrdersATieBySideActionsThenTheirTravel) {
  EXPECT_EQ(ranked({{.exact = true, .actions = 2.0}, {.actions = 1.2}}).order, (Numbers{1, 0}));
  EXPECT_EQ(
      ranked({{.depth = 1.0, .actions = 2.0, .travel = 5.0}, {.depth = 9.0, .actions = 2.0, .travel = 3.0}})
          .order,
      (Numbers{1, 0}));
  EXPECT_EQ(ranked({{.depth = 9.0, .travel = 3.01}, {.depth = 1.0, .travel = 3.02}}).order, (Numbers{1, 0}))
      << "a thousandth of the diagonal decides nothing";
  EXPECT_EQ(ranked({{.undercut = 1.0, .actions = 9.0}, {.undercut = 2.0, .actions = 1.0}}).order,
            (Numbers{0, 1}))
      << "they do not tie";
}

TEST(Ranking, PutsWhatIsNotDecidedBehind) {
  const Ranking ranking =
      ranked({{.undercut = 1.0, .decided = false}, {.undercut = 3.0}, {.undercut = 1.0, .decided = false}});
  EXPECT_EQ(ranking.order, (Numbers{1, 0, 2}));
  EXPECT_EQ(ranking.tie_group, (Numbers{1, 0, 1}));
  EXPECT_EQ(ranked({{.undercut = 2.0, .decided = false}, {.undercut = 2.0}}).tie_group, (Numbers{1, 0}));
}

TEST(Ranking, FollowsTheObjective) {
  const std::vector<Given> given = {{.undercut = 10.0, .depth = 2.0}, {.undercut = 0.0, .depth = 5.0}};
  EXPECT_EQ(ranked(given).order, (Numbers{1, 0}));
  EXPECT_EQ(ranked(given, [](const Given& one) { return one.depth; }).order, (Numbers{0, 1}));
}

TEST(Ranking, TheParetoFrontIsWhatNothingBeatsInAllThree) {
  using Front = std::vector<bool>;
  const auto front = [](const Given& a, const Given& b) { return ranked({a, b}).pareto; };
  EXPECT_EQ(front({.undercut = 1.0}, {.undercut = 2.0}), (Front{true, false}));
  EXPECT_EQ(front({.undercuts = 1.0}, {.undercuts = 2.0}), (Front{true, false}));
  EXPECT_EQ(front({.depth = 1.0}, {.depth = 2.0}), (Front{true, false}));
  EXPECT_EQ(front({.undercut = 1.0, .undercuts = 3.0}, {.undercut = 2.0, .undercuts = 2.0}),
            (Front{true, true}));
  EXPECT_EQ(front({.undercut = 1.0, .depth = 3.0}, {.undercut = 2.0, .depth = 2.0}), (Front{true, true}));
  EXPECT_EQ(front({.undercuts = 1.0, .depth = 3.0}, {.undercuts = 2.0, .depth = 2.0}), (Front{true, true}));
  EXPECT_EQ(front({.undercut = 1.0, .uncertainty = 0.6}, {.undercut = 2.0, .uncertainty = 0.6}),
            (Front{true, true}))
      << "undercut areas that could be equal";
  EXPECT_EQ(front({.projected = 1.0}, {.projected = 2.0}), (Front{true, true})) << "does not count";
}

}  // namespace
}  // namespace moldlight
