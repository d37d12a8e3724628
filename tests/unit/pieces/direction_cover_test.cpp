// Covers against all choices tried.
#include "pieces/direction_cover.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace moldlight {
namespace {

struct Instance {
  std::vector<SampleGroup> groups;
  std::vector<BitSet> columns;
  [[nodiscard]] CoverTask task() const { return {groups, columns}; }
};

Instance random_instance(std::uint32_t seed, std::size_t columns) {
  test::Random random(seed);
  Instance made;
  made.groups = {{.first = 0, .count = 70, .spare = random.below(6)},
                 {.first = 128, .count = 20, .spare = random.below(4)}};
  const double density = random.between(0.15, 0.5);
  for (std::size_t c = 0; c < columns; ++c) {
    BitSet column(148);
    for (const SampleGroup& group : made.groups) {
      for (std::size_t k = 0; k < group.count; ++k) {
        if (random.chance(density)) column.set(group.first + k);
      }
    }
    made.columns.push_back(std::move(column));
  }
  return made;
}

std::vector<std::size_t> all_of(const Instance& instance) {
  std::vector<std::size_t> all(instance.columns.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Fewest columns of all subsets; one more than there are where none do.
std::size_t fewest_by_trying(const Instance& instance) {
  const std::size_t count = instance.columns.size();
  std::size_t fewest = count + 1;
  for (std::size_t bits = 0; bits < std::size_t{1} << count; ++bits) {
    std::vector<std::size_t> chosen;
    for (std::size_t c = 0; c < count; ++c) {
      if ((bits >> c & 1U) != 0) chosen.push_back(c);
    }
    if (chosen.size() < fewest && leaves_enough(instance.task(), left_by(instance.task(), chosen)))
      fewest = chosen.size();
  }
  return fewest;
}

std::size_t fewest_by_search(const Instance& instance) {
  const std::vector<std::size_t> all = all_of(instance);
  const Progress progress;
  CoverSearch search(instance.task(), all, progress);
  for (std::size_t most = 0; most <= all.size(); ++most) {
    const DirectionCover cover = search.find({.most = most, .most_nodes = 1'000'000});
    EXPECT_TRUE(cover.complete);
    if (!cover.found) continue;
    EXPECT_LE(cover.columns.size(), most);
    EXPECT_TRUE(leaves_enough(instance.task(), left_by(instance.task(), cover.columns)));
    return most;
  }
  return all.size() + 1;
}

TEST(DirectionCover, IsAsSmallAsTheSmallestOfAllChoices) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const Instance instance = random_instance(seed, 11);
    EXPECT_EQ(fewest_by_search(instance), fewest_by_trying(instance)) << "seed " << seed;
  }
}

TEST(DirectionCover, MoreColumnsNeverAskForMore) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Instance instance = random_instance(seed, 18);
    const std::size_t with_all = fewest_by_search(instance);
    instance.columns.resize(10);
    const std::size_t with_some = fewest_by_search(instance);
    EXPECT_TRUE(with_some > 10 || with_all <= with_some) << "seed " << seed;
  }
}

TEST(DirectionCover, KeepsWhatIsForced) {
  const Instance instance = random_instance(3, 12);
  const std::vector<std::size_t> all = all_of(instance);
  const Progress progress;
  CoverSearch search(instance.task(), all, progress);
  const DirectionCover cover = search.find({.forced = {7, 2}, .most = 12});
  ASSERT_TRUE(cover.found);
  EXPECT_EQ(cover.columns[0], 7U);
  EXPECT_EQ(cover.columns[1], 2U);
}

TEST(DirectionCover, SaysWhereItWasCutShort) {
  const Progress progress;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Instance instance = random_instance(seed, 16);
    const std::vector<std::size_t> all = all_of(instance);
    CoverSearch search(instance.task(), all, progress);
    const DirectionCover full = search.find({.most = 4, .most_nodes = 1'000'000});
    const DirectionCover cut = search.find({.most = 4, .most_nodes = 2});
    EXPECT_TRUE(full.complete);
    EXPECT_TRUE(!cut.complete || cut.found == full.found) << "seed " << seed;
    EXPECT_TRUE(!cut.found || full.found) << "seed " << seed;
  }
}

TEST(DirectionCover, GreedyTakesTheLikedOfThoseThatDoAsWell) {
  Instance instance;
  instance.groups = {{.first = 0, .count = 40, .spare = 0}};
  for (const std::size_t reached : {20U, 19U, 5U}) {
    BitSet column(40);
    for (std::size_t k = 0; k < reached; ++k) column.set(k);
    instance.columns.push_back(column);
  }
  const auto liking = [](std::size_t column) { return column == 1 ? 0 : 1; };
  const DirectionCover cover = greedy_cover(instance.task(), {.most = 1}, liking);
  EXPECT_EQ(cover.columns, std::vector<std::size_t>{1});
}

/// The one that reaches most alone is of little use beside any other.
TEST(DirectionCover, GreedyTakesTwoThatReachMoreTogether) {
  Instance instance;
  instance.groups = {{.first = 0, .count = 48, .spare = 0}};
  for (const auto& [from, to] : {std::pair(10U, 38U), std::pair(0U, 24U), std::pair(24U, 48U)}) {
    BitSet column(48);
    for (std::size_t k = from; k < to; ++k) column.set(k);
    instance.columns.push_back(column);
  }
  const auto alike = [](std::size_t) { return 0; };
  EXPECT_EQ(greedy_cover(instance.task(), {.most = 1}, alike).columns, std::vector<std::size_t>{0});
  EXPECT_EQ(greedy_cover(instance.task(), {.most = 2}, alike).columns, (std::vector<std::size_t>{1, 2}));
}

/// Small places go after the surface, but before nothing at all.
TEST(DirectionCover, GreedyGoesOnWithSmallPlaces) {
  Instance instance;
  instance.groups = {{.first = 0, .count = 8, .spare = 0}, {.first = 64, .count = 40, .spare = 0}};
  for (const auto& [from, to] : {std::pair(0U, 8U), std::pair(64U, 104U)}) {
    BitSet column(104);
    for (std::size_t k = from; k < to; ++k) column.set(k);
    instance.columns.push_back(column);
  }
  const auto alike = [](std::size_t) { return 0; };
  EXPECT_EQ(greedy_cover(instance.task(), {.most = 1}, alike).columns, std::vector<std::size_t>{0});
  EXPECT_EQ(greedy_cover(instance.task(), {.most = 2}, alike).columns, (std::vector<std::size_t>{0, 1}));
}

TEST(DirectionCover, CanBeCancelled) {
  const Instance instance = random_instance(1, 12);
  const std::vector<std::size_t> all = all_of(instance);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(CoverSearch(instance.task(), all, progress), Cancelled);
}

}  // namespace
}  // namespace moldlight
