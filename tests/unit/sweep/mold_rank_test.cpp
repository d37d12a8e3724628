#include "sweep/mold_rank.hpp"

#include <cmath>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

namespace moldlight {
namespace {

using enum MoldCriterion;
using Numbers = std::vector<std::size_t>;

MoldCost cost(std::initializer_list<std::pair<MoldCriterion, double>> values) {
  MoldCost made;
  for (const auto& [criterion, value] : values) made.of(criterion) = value;
  return made;
}

Numbers order(const std::vector<MoldCost>& costs) { return mold_order(costs).order; }

TEST(MoldRank, WhatIsFormedInVainAddsNoEffort) {
  MoldCost few = cost({}), many = cost({});
  few.weight = 2.0;
  many.weight = 13.0;
  many.in_vain = 11.5;
  EXPECT_DOUBLE_EQ(mold_effort(many), 1.5);
  EXPECT_LT(mold_effort(many), mold_effort(few));
  EXPECT_TRUE(costs_no_more(few, many)) << "by its whole weight";
  EXPECT_TRUE(costs_no_more(many, few)) << "without what does not count";
  many.in_vain = 10.0;
  EXPECT_FALSE(costs_no_more(many, few));
}

TEST(MoldRank, ComparesByOneCriterionAfterTheOther) {
  EXPECT_EQ(order({cost({{found, 1.0}}), cost({{unreleased, 0.5}})}), (Numbers{1, 0}));
  EXPECT_EQ(order({cost({{unreleased, 0.1}}), cost({{effort, 9.0}})}), (Numbers{1, 0}));
  EXPECT_EQ(order({cost({{effort, 1.2}}), cost({{effort, 1.0}, {line, 0.5}})}), (Numbers{1, 0}));
  EXPECT_EQ(order({cost({{draft, 0.3}}), cost({{draft, 0.1}, {undercut, 0.2}})}), (Numbers{1, 0}));
  EXPECT_EQ(order({cost({{depth, 0.3}}), cost({{depth, 0.1}})}), (Numbers{1, 0}));
}

TEST(MoldRank, WhatDiffersByLessThanABandTies) {
  for (std::size_t k = 0; k < k_mold_criteria; ++k) {
    const auto criterion = static_cast<MoldCriterion>(k);
    const double band = mold_band(criterion);
    EXPECT_EQ(order({cost({{criterion, 0.9 * band}}), {}}), (Numbers{0, 1})) << k;
    EXPECT_EQ(order({cost({{criterion, 1.1 * band}}), {}}), (Numbers{1, 0})) << k;
    EXPECT_EQ(mold_order(std::vector{cost({{criterion, 0.9 * band}}), MoldCost{}}).decided_by[1],
              std::nullopt);
    EXPECT_EQ(mold_order(std::vector{cost({{criterion, 1.1 * band}}), MoldCost{}}).decided_by[1], criterion);
  }
}

TEST(MoldRank, AShareOfWhatIsLeftUnreleasedTies) {
  EXPECT_EQ(order({cost({{unreleased, 0.235}}), cost({{unreleased, 0.2}, {line, 0.5}})}), (Numbers{0, 1}));
  EXPECT_EQ(order({cost({{unreleased, 0.245}}), cost({{unreleased, 0.2}, {line, 0.5}})}), (Numbers{1, 0}));
}

TEST(MoldRank, IsTheSameInWhateverOrderTheyCome) {
  const MoldCost a = cost({{effort, 1.0}, {line, 0.3}}), b = cost({{effort, 1.0}, {draft, 0.1}}),
                 c = cost({{effort, 2.0}});
  EXPECT_EQ(order({a, b, c}), (Numbers{1, 0, 2}));
  EXPECT_EQ(order({c, a, b}), (Numbers{2, 1, 0}));
}

TEST(MoldRank, SaysWhatDecides) {
  MoldCost one = cost({{effort, 2.4}}), other = cost({{effort, 1.0}, {line, 0.25}});
  one.weight = 2.4;
  one.counts[static_cast<std::size_t>(ActionKind::lifter)] = 2;
  other.weight = 1.0;
  other.counts[static_cast<std::size_t>(ActionKind::slide)] = 1;
  EXPECT_EQ(rank_reasons(one, other),
            (std::vector<std::string>{"needs 2 lifters more, 1 slide less",
                                      "but its parting line climbs 25 % of the diagonal less"}));
  MoldCost many = cost({{unreleased, 0.02}});
  EXPECT_EQ(rank_reasons(many, {}), (std::vector<std::string>{"leaves 2 % more of the surface unreleased"}));
  many.beyond = 0.01;
  EXPECT_EQ(rank_reasons(many, {}),
            (std::vector<std::string>{"leaves 2 % more of the surface unreleased with 8 side actions"}));
  EXPECT_TRUE(rank_reasons(one, one).empty());
}

TEST(MoldRank, AddsToTheWeightWhatSideActionsFormAndDraftAndLine) {
  MoldCost one = cost({{draft, 0.5}, {line, 3.0}}), other = cost({{draft, 0.5}, {line, 0.0}});
  one.weight = 1.0;
  one.counts[static_cast<std::size_t>(ActionKind::slide)] = 1;
  one.formed = 0.4;
  other.weight = 2.0;
  other.counts[static_cast<std::size_t>(ActionKind::slide)] = 2;
  EXPECT_DOUBLE_EQ(mold_effort(one), 1.0 + 2.0 + 1.0 + 2.0);
  EXPECT_DOUBLE_EQ(mold_effort(other), 2.0 + 1.0);
  EXPECT_EQ(rank_reasons(one, other),
            (std::vector<std::string>{"its side actions form 40 % more of the surface",
                                      "its parting line climbs 300 % of the diagonal more",
                                      "but needs 1 slide less"}));
}

MoldCost of_weight(double weight, bool canonical, double left = 0.0) {
  MoldCost made = cost({{unreleased, left}, {effort, weight}, {support, 1.0}});
  made.weight = weight;
  made.canonical = canonical;
  return made;
}

TEST(MoldRank, LyingOnItsSideIsDearWhereThePartCanStand) {
  MoldCost standing = of_weight(3.0, true), lying = of_weight(1.0, true);
  standing.formed = 0.1;
  lying.formed = 0.4;
  std::vector<MoldCost> costs = {lying, standing};
  settle(costs);
  settle(costs);
  EXPECT_DOUBLE_EQ(costs[0].of(effort), 1.0 + 40.0 * (0.4 - 0.3));
  EXPECT_DOUBLE_EQ(costs[1].of(effort), 3.0);
  EXPECT_EQ(order(costs), (Numbers{1, 0}));
  // Bores that cross: no direction leaves them to the halves.
  costs[1].formed = 0.25;
  settle(costs);
  EXPECT_DOUBLE_EQ(costs[0].of(effort), 1.0);
  // What leaves surface unreleased says nothing of where the part can stand.
  costs[1] = of_weight(3.0, true, 0.2);
  settle(costs);
  EXPECT_DOUBLE_EQ(costs[0].of(effort), 1.0);
}

TEST(MoldRank, ARestThatNothingReleasesWeighsMoreThanAnyAction) {
  EXPECT_DOUBLE_EQ(mold_effort(cost({{unreleased, 0.02}})), 4.0);
  EXPECT_DOUBLE_EQ(mold_effort(cost({{unreleased, 5e-5}})), 0.0) << "a speck";
}

TEST(MoldRank, WhatMoreOfThePartNamesBeatsWhatLessDoesBesideIt) {
  MoldCost block = of_weight(1.0, true), holes = of_weight(1.0, true);
  block.direction = {0, 0, 1};
  block.of(support) = 0.4;
  block.of(draft) = 0.9;
  holes.direction = {0, std::sin(glm::radians(8.0)), std::cos(glm::radians(8.0))};
  holes.of(support) = 0.9;
  std::vector<MoldCost> costs = {holes, block};
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{1, 0}));
  EXPECT_EQ(rank_reasons(costs[0], costs[1]).front(),
            "is within 10° of a direction that more of the walls follow");

  costs[0].weight = costs[0].of(effort) = 0.0;
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{0, 1})) << "it needs a slide less";
  costs[0].weight = costs[0].of(effort) = 1.0;
  costs[0].direction = {0, std::sin(glm::radians(11.0)), std::cos(glm::radians(11.0))};
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{0, 1})) << "it is not beside it";
}

TEST(MoldRank, APartThatHasToBeChangedIsNotTilted) {
  std::vector<MoldCost> costs = {of_weight(1.0, false, 0.05), of_weight(3.0, true, 0.09)};
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{1, 0}));
  costs[1].of(unreleased) = 0.11;
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{0, 1})) << "more than a twentieth of the surface";
  costs[1].of(support) = 0.4;
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{1, 0})) << "most walls follow it";
  costs[1].of(unreleased) = 0.26;
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{0, 1})) << "more than a fifth of the surface";
  costs = {of_weight(1.0, false, 0.0), of_weight(3.0, true, 0.04)};
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{0, 1})) << "it releases everything";
}

TEST(MoldRank, APartIsNotTiltedForAHeapOfSideActions) {
  // All is released by five slides, a lifter and a loose insert where the mold is tilted.
  MoldCost axis = cost({{unreleased, 0.034}, {support, 0.7}}), tilted = cost({});
  axis.canonical = true;
  axis.weight = 4.0;
  tilted.direction = {0.08, 0.0, 0.997};
  for (const double weight : {7.5, 9.2}) {
    tilted.weight = weight;
    std::vector<MoldCost> costs = {axis, tilted};
    settle(costs);
    EXPECT_EQ(costs[1].of(found), weight > 8.0 ? 1.0 : 0.0) << weight;
  }
  // More than a twentieth of the surface is no small change.
  axis.of(unreleased) = 0.08;
  std::vector<MoldCost> costs = {axis, tilted};
  settle(costs);
  EXPECT_EQ(costs[1].of(found), 0.0);
}

TEST(MoldRank, CostIsWhatNothingReleasesAndSideActions) {
  EXPECT_TRUE(costs_no_more(cost({{line, 0.9}, {effort, 3.0}}), {})) << "by the weight alone";
  EXPECT_TRUE(costs_no_more(of_weight(1.0, true), of_weight(1.2, true)));
  EXPECT_FALSE(costs_no_more(of_weight(1.2, true), of_weight(1.0, true)));
  EXPECT_FALSE(costs_no_more(of_weight(0.0, true, 0.1), of_weight(1.0, true)));
}

TEST(MoldRank, WhatWasFoundMustBeatAllThatTheShapeNames) {
  std::vector<MoldCost> costs = {of_weight(1.0, false), of_weight(1.0, true), of_weight(3.0, true)};
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{1, 2, 0}));
  EXPECT_EQ(rank_reasons(costs[0], costs[1]).front(), "is not an axis or a face normal of the part");
  costs = {of_weight(2.0, true), of_weight(1.0, false)};
  settle(costs);
  EXPECT_EQ(order(costs), (Numbers{1, 0}));
}

TEST(MoldTrade, SaysWhatIsWonAndCosts) {
  MoldCost one = cost({{effort, 1.0}, {line, 0.25}}), other = cost({{effort, 2.0}});
  one.weight = 1.0;
  one.counts[static_cast<std::size_t>(ActionKind::slide)] = 1;
  other.weight = 2.0;
  other.counts[static_cast<std::size_t>(ActionKind::slide)] = 2;
  const MoldTrade trade = mold_trade(one, other);
  EXPECT_TRUE(trade.worth);
  EXPECT_EQ(trade.wins, std::vector<std::string>{"needs 1 slide less"});
  EXPECT_EQ(trade.costs, std::vector<std::string>{"its parting line climbs 25 % of the diagonal more"});
  const MoldTrade back = mold_trade(other, one);
  EXPECT_TRUE(back.worth) << "its line is worth a slide";
  other.weight = 3.0;
  EXPECT_FALSE(mold_trade(other, one).worth) << "but not two";
  EXPECT_EQ(back.costs, std::vector<std::string>{"needs 1 slide more"});
}

TEST(MoldTrade, GainsBelowTwoPercentAreNoReason) {
  for (const MoldCriterion criterion : {line, draft, undercut}) {
    EXPECT_FALSE(mold_trade({}, cost({{criterion, 0.019}})).worth);
    EXPECT_TRUE(mold_trade({}, cost({{criterion, 0.021}})).worth);
    EXPECT_FALSE(mold_trade({}, cost({{criterion, 0.021}})).wins.empty());
  }
  EXPECT_FALSE(mold_trade({}, cost({{depth, 0.5}})).worth);
  EXPECT_FALSE(mold_trade(cost({{unreleased, 0.01}}), cost({{unreleased, 0.029}})).worth);
  EXPECT_TRUE(mold_trade({}, cost({{unreleased, 0.001}})).worth) << "then all is released";
}

TEST(MoldTrade, NothingIsWorthSurfaceThatNothingReleases) {
  for (const MoldCriterion criterion : {line, draft, undercut})
    EXPECT_FALSE(mold_trade(cost({{unreleased, 0.002}}), cost({{criterion, 0.5}})).worth);
  MoldCost heavier;
  heavier.weight = 1.0;
  for (const MoldCriterion criterion : {draft, undercut})
    EXPECT_FALSE(mold_trade(heavier, cost({{criterion, 0.5}})).worth) << "nor a side action";
  EXPECT_TRUE(mold_trade(heavier, cost({{unreleased, 0.5}})).worth) << "which releases something";
}

TEST(MoldTrade, WorseActionsLineAndUnreleasedSurfaceAreToldEvenWithinTheBands) {
  MoldCost heavier;
  heavier.weight = 0.4 * mold_band(effort);
  heavier.counts[static_cast<std::size_t>(ActionKind::lifter)] = 1;
  EXPECT_EQ(mold_trade(heavier, {}).costs, std::vector<std::string>{"needs 1 lifter more"});
  EXPECT_EQ(mold_trade(cost({{line, 0.01}}), {}).costs,
            std::vector<std::string>{"its parting line climbs 1 % of the diagonal more"});
  EXPECT_EQ(mold_trade(cost({{unreleased, 0.002}}), {}).costs,
            std::vector<std::string>{"leaves 0.2 % more of the surface unreleased"});
  EXPECT_TRUE(mold_trade({}, {}).costs.empty());
  EXPECT_TRUE(mold_trade(cost({{found, 1.0}}), {}).costs.empty());
}

}  // namespace
}  // namespace moldlight
