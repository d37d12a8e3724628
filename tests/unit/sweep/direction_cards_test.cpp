// The cards of a ranking: which directions, and what they say.
#include "sweep/direction_cards.hpp"

#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

using enum MoldCriterion;

const glm::dvec3 k_x(1, 0, 0), k_y(0, 1, 0), k_z(0, 0, 1);

MoldCost cost_of(std::size_t slides, double climb, double undercut = 0.0) {
  MoldCost made;
  made.weight = static_cast<double>(slides);
  made.counts[static_cast<std::size_t>(ActionKind::slide)] = slides;
  made.of(line) = climb;
  made.of(MoldCriterion::undercut) = undercut;
  return made;
}

class DirectionCards : public testing::Test {
 protected:
  DirectionCards() : model_(test::model_of(test::box_shape({}).mesh)) {}

  void add(const glm::dvec3& direction, const std::optional<MoldCost>& cost) {
    SweepCandidate candidate;
    candidate.candidate.direction = direction;
    candidate.cost = cost;
    result_.candidates.push_back(candidate);
  }
  /// As the ranking has them, the first recommended with the core on the side of -z.
  void rank_three() {
    add(k_z, cost_of(0, 0.3));
    add(k_x, cost_of(2, 0.3));  // worse in all
    add(k_y, cost_of(1, 0.0));
    result_.recommended = Recommendation{.direction = -k_z};
  }
  [[nodiscard]] std::vector<DirectionCard> cards(const glm::dvec3& here,
                                                 const std::optional<MoldCost>& cost = std::nullopt) const {
    return direction_cards(*model_, result_, here, cost);
  }

  std::shared_ptr<const PartModel> model_;
  SweepResult result_;
};

TEST_F(DirectionCards, AreTheRecommendedOneAndWhatWinsSomethingBesideIt) {
  rank_three();
  const auto found = cards(k_x, cost_of(2, 0.3));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].direction, -k_z) << "with its core side";
  EXPECT_EQ(found[0].name, "-z");
  EXPECT_EQ(found[1].name, "+y");
  EXPECT_EQ(found[1].candidate, 2U);
  EXPECT_TRUE(found[0].offered && found[1].offered);
  EXPECT_EQ(found[0].trade.wins, std::vector<std::string>{"needs 2 slides less"});
}

TEST_F(DirectionCards, SayWhatATurnCosts) {
  rank_three();
  const auto at_best = cards(k_z, cost_of(0, 0.3));
  ASSERT_EQ(at_best.size(), 2U);
  EXPECT_TRUE(at_best[0].here);
  EXPECT_FALSE(at_best[0].offered);
  EXPECT_TRUE(at_best[1].offered);
  EXPECT_EQ(better_direction(at_best), nullptr) << "a trade is no better direction";
  EXPECT_EQ(at_best[1].trade.costs, std::vector<std::string>{"needs 1 slide more"});
  const auto at_other = cards(-k_y, cost_of(1, 0.0));
  ASSERT_EQ(at_other.size(), 2U);
  EXPECT_TRUE(at_other[1].here) << "opposite directions are one";
  EXPECT_EQ(better_direction(at_other), &at_other[0]);
  EXPECT_EQ(at_other[0].trade.costs,
            std::vector<std::string>{"its parting line climbs 30 % of the diagonal more"});
}

TEST_F(DirectionCards, OfferNoGainBelowTwoPercent) {
  add(k_z, cost_of(1, 0.0, 0.05));
  result_.recommended = Recommendation{.direction = k_z};
  const glm::dvec3 aside(0.0, 0.1, 1.0);
  EXPECT_FALSE(cards(aside, cost_of(1, 0.0, 0.069))[0].offered);
  EXPECT_TRUE(cards(aside, cost_of(1, 0.0, 0.071))[0].offered);
  EXPECT_TRUE(cards(aside)[0].offered) << "until more is known";
  EXPECT_TRUE(cards(aside)[0].trade.wins.empty());
}

TEST_F(DirectionCards, AreAtMostThreeAndNoneWithoutARecommendation) {
  rank_three();
  for (const double climb : {0.1, 0.05, 0.01}) add({0.1, climb, 1.0}, cost_of(1, climb));
  EXPECT_EQ(cards(k_x).size(), 3U);
  add({1, 1, 0}, std::nullopt);
  EXPECT_EQ(cards({1, 1, 0}).size(), 3U) << "what was given up is no choice";
  result_.recommended.reset();
  EXPECT_TRUE(cards(k_x).empty());
}

}  // namespace
}  // namespace moldlight
