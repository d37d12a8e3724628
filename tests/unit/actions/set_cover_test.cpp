// The least set of actions against brute force.
#include "actions/set_cover.hpp"

#include <bit>
#include <random>

#include <gtest/gtest.h>

namespace moldlight {
namespace {

double price_of(const std::vector<CoverClash>& clashes, std::uint32_t chosen) {
  double price = 0.0;
  for (const CoverClash& clash : clashes)
    price += (chosen >> clash.a & chosen >> clash.b & 1U) != 0 ? clash.price : 0.0;
  return price;
}

/// The least cost of options that cover every undercut part that any option has, with the prices of their
/// clashes.
double brute_force(std::size_t undercut_parts, const std::vector<CoverOption>& options,
                   const std::vector<CoverClash>& clashes = {}) {
  std::vector<std::uint32_t> masks;
  std::uint32_t all = 0;
  for (const CoverOption& option : options) {
    std::uint32_t mask = 0;
    for (const std::size_t undercut_part : option.undercut_parts) mask |= 1U << undercut_part;
    masks.push_back(mask);
    all |= mask;
  }
  EXPECT_LE(std::bit_width(all), static_cast<int>(undercut_parts));
  double best = all == 0 ? 0.0 : 1e300;
  for (std::uint32_t chosen = 1; chosen < (1U << options.size()); ++chosen) {
    std::uint32_t covered = 0;
    double cost = 0.0;
    for (std::size_t c = 0; c < options.size(); ++c) {
      if ((chosen >> c & 1U) == 0) continue;
      covered |= masks[c];
      cost += options[c].cost;
    }
    if (covered != all || cost >= best) continue;
    best = std::min(best, cost + price_of(clashes, chosen));
  }
  return best;
}

std::vector<CoverOption> random_options(std::mt19937& random, std::size_t undercut_parts, std::size_t count) {
  std::vector<CoverOption> options(count);
  for (CoverOption& option : options) {
    for (std::size_t undercut_part = 0; undercut_part < undercut_parts; ++undercut_part) {
      if (random() % 4 == 0) option.undercut_parts.push_back(undercut_part);
    }
    option.cost = 0.5 + 0.25 * static_cast<double>(random() % 8);
  }
  return options;
}

TEST(SetCover, IsTheCheapestOfRandomTables) {
  std::mt19937 random(7);
  std::size_t with_uncovered = 0;
  for (int table = 0; table < 1000; ++table) {
    const std::size_t undercut_parts = 1 + random() % 12, count = 1 + random() % (table % 50 == 0 ? 20 : 12);
    const std::vector<CoverOption> options = random_options(random, undercut_parts, count);
    const Cover cover = least_cover(undercut_parts, options);
    EXPECT_TRUE(cover.optimal);
    EXPECT_NEAR(cover.cost, brute_force(undercut_parts, options), 1e-12) << table;
    std::vector<char> covered(undercut_parts, 0);
    double cost = 0.0;
    for (const std::size_t c : cover.options) {
      cost += options[c].cost;
      for (const std::size_t undercut_part : options[c].undercut_parts) covered[undercut_part] = 1;
    }
    EXPECT_NEAR(cost, cover.cost, 1e-12);
    for (const std::size_t undercut_part : cover.uncovered) {
      EXPECT_EQ(covered[undercut_part], 0);
      covered[undercut_part] = 1;
      ++with_uncovered;
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<std::ptrdiff_t>(undercut_parts))
        << table;
  }
  EXPECT_GT(with_uncovered, 100U);
}

/// Prices that rule a clash out wherever it can be helped, and such as may be worth it.
TEST(SetCover, IsTheCheapestOfRandomTablesWithClashes) {
  constexpr double k_high = 100.0;
  std::mt19937 random(17);
  std::size_t dearer = 0, unavoidable = 0;
  for (int table = 0; table < 1000; ++table) {
    const std::size_t undercut_parts = 1 + random() % 12, count = 2 + random() % (table % 50 == 0 ? 19 : 13);
    const bool high = table % 3 != 0;
    const std::vector<CoverOption> options = random_options(random, undercut_parts, count);
    std::vector<CoverClash> clashes;
    const std::size_t one_of = 2 + random() % 6;
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (random() % one_of == 0)
          clashes.push_back({a, b, high ? k_high : 0.25 * static_cast<double>(random() % 8)});
      }
    }
    const Cover cover = least_cover(undercut_parts, options, clashes),
                careless = least_cover(undercut_parts, options);
    EXPECT_TRUE(cover.optimal);
    EXPECT_NEAR(cover.cost, brute_force(undercut_parts, options, clashes), 1e-9) << table;
    EXPECT_EQ(cover.uncovered, careless.uncovered) << table;
    std::uint32_t chosen = 0;
    double cost = 0.0;
    for (const std::size_t c : cover.options) {
      chosen |= 1U << c;
      cost += options[c].cost;
    }
    EXPECT_NEAR(cost + price_of(clashes, chosen), cover.cost, 1e-9) << table;
    dearer += high && cover.cost > careless.cost && cover.cost < k_high ? 1 : 0;
    unavoidable += cover.cost >= k_high ? 1 : 0;
  }
  EXPECT_GT(dearer, 50U);
  EXPECT_GT(unavoidable, 50U);
}

TEST(SetCover, GivenUpEarlySaysSo) {
  std::mt19937 random(3);
  std::vector<CoverOption> options(60);
  for (CoverOption& option : options) {
    for (std::size_t undercut_part = 0; undercut_part < 40; ++undercut_part) {
      if (random() % 6 == 0) option.undercut_parts.push_back(undercut_part);
    }
    option.cost = 1.0 + 1e-3 * static_cast<double>(random() % 100);
  }
  const Cover hasty = least_cover(40, options, {}, 50), thorough = least_cover(40, options, {}, 1'000'000);
  EXPECT_FALSE(hasty.optimal);
  EXPECT_TRUE(hasty.uncovered.empty());
  EXPECT_GE(hasty.cost, thorough.cost);
}

}  // namespace
}  // namespace moldlight
