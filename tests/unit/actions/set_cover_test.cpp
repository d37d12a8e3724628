// The least set of actions against brute force.
#include "actions/set_cover.hpp"

#include <bit>
#include <random>

#include <gtest/gtest.h>

namespace moldlight {
namespace {

/// The least cost of columns that cover every atom that any column has.
double brute_force(std::size_t atoms, const std::vector<CoverColumn>& columns) {
  std::vector<std::uint32_t> masks;
  std::uint32_t all = 0;
  for (const CoverColumn& column : columns) {
    std::uint32_t mask = 0;
    for (const std::size_t atom : column.atoms) mask |= 1U << atom;
    masks.push_back(mask);
    all |= mask;
  }
  EXPECT_LE(std::bit_width(all), static_cast<int>(atoms));
  double best = all == 0 ? 0.0 : 1e300;
  for (std::uint32_t chosen = 1; chosen < (1U << columns.size()); ++chosen) {
    std::uint32_t covered = 0;
    double cost = 0.0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if ((chosen >> c & 1U) == 0) continue;
      covered |= masks[c];
      cost += columns[c].cost;
    }
    if (covered == all) best = std::min(best, cost);
  }
  return best;
}

TEST(SetCover, IsTheCheapestOfRandomTables) {
  std::mt19937 random(7);
  std::size_t with_uncovered = 0;
  for (int table = 0; table < 1000; ++table) {
    const std::size_t atoms = 1 + random() % 12, count = 1 + random() % (table % 50 == 0 ? 20 : 12);
    std::vector<CoverColumn> columns(count);
    for (CoverColumn& column : columns) {
      for (std::size_t atom = 0; atom < atoms; ++atom) {
        if (random() % 4 == 0) column.atoms.push_back(atom);
      }
      column.cost = 0.5 + 0.25 * static_cast<double>(random() % 8);
    }
    const Cover cover = least_cover(atoms, columns);
    EXPECT_TRUE(cover.optimal);
    EXPECT_NEAR(cover.cost, brute_force(atoms, columns), 1e-12) << table;
    std::vector<char> covered(atoms, 0);
    double cost = 0.0;
    for (const std::size_t c : cover.columns) {
      cost += columns[c].cost;
      for (const std::size_t atom : columns[c].atoms) covered[atom] = 1;
    }
    EXPECT_NEAR(cost, cover.cost, 1e-12);
    for (const std::size_t atom : cover.uncovered) {
      EXPECT_EQ(covered[atom], 0);
      covered[atom] = 1;
      ++with_uncovered;
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<std::ptrdiff_t>(atoms)) << table;
  }
  EXPECT_GT(with_uncovered, 100U);
}

TEST(SetCover, GivenUpEarlySaysSo) {
  std::mt19937 random(3);
  std::vector<CoverColumn> columns(60);
  for (CoverColumn& column : columns) {
    for (std::size_t atom = 0; atom < 40; ++atom) {
      if (random() % 6 == 0) column.atoms.push_back(atom);
    }
    column.cost = 1.0 + 1e-3 * static_cast<double>(random() % 100);
  }
  const Cover hasty = least_cover(40, columns, 50), thorough = least_cover(40, columns, 1'000'000);
  EXPECT_FALSE(hasty.optimal);
  EXPECT_TRUE(hasty.uncovered.empty());
  EXPECT_GE(hasty.cost, thorough.cost);
}

}  // namespace
}  // namespace moldlight
