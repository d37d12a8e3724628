// Minimum cuts against all answers tried.
#include "parting/min_cut.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace moldlight {
namespace {

TEST(MinCut, IsTheLeastOfAllAnswers) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    test::Random random(seed);
    constexpr std::uint32_t k_nodes = 10;
    MinCut cut(k_nodes);
    std::array<std::array<double, 2>, k_nodes> costs{};
    std::array<std::array<double, k_nodes>, k_nodes> links{};
    for (std::uint32_t a = 0; a < k_nodes; ++a) {
      for (int side = 0; side < 2; ++side) {
        costs[a][static_cast<std::size_t>(side)] = random.between(0.0, 1.0);
        cut.add_cost(a, side, costs[a][static_cast<std::size_t>(side)]);
      }
      for (std::uint32_t b = a + 1; b < k_nodes; ++b) {
        links[a][b] = random.between(0.0, 1.0) < 0.3 ? random.between(0.0, 1.0) : 0.0;
        cut.add_link(a, b, links[a][b]);
      }
    }
    const auto energy = [&](const auto& sides) {
      double sum = 0.0;
      for (std::uint32_t a = 0; a < k_nodes; ++a) {
        sum += costs[a][sides[a]];
        for (std::uint32_t b = a + 1; b < k_nodes; ++b) sum += sides[a] != sides[b] ? links[a][b] : 0.0;
      }
      return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t bits = 0; bits < 1U << k_nodes; ++bits) {
      std::array<std::uint8_t, k_nodes> sides{};
      for (std::uint32_t a = 0; a < k_nodes; ++a) sides[a] = static_cast<std::uint8_t>(bits >> a & 1U);
      least = std::min(least, energy(sides));
    }
    EXPECT_NEAR(energy(cut.solve(Progress{})), least, 1e-9) << "seed " << seed;
  }
}

TEST(MinCut, OfNothingIsNothing) {
  EXPECT_TRUE(MinCut(0).solve(Progress{}).empty());
  EXPECT_EQ(MinCut(3).solve(Progress{}).size(), 3U);
}

TEST(MinCut, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  MinCut two(2);
  two.add_cost(0, 1, 1.0);
  two.add_cost(1, 0, 1.0);
  two.add_link(0, 1, 1.0);
  EXPECT_THROW(static_cast<void>(two.solve(progress)), Cancelled);
}

}  // namespace
}  // namespace moldlight
