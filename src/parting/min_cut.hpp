// Minimum cut of a graph whose nodes choose one of two sides: by maximum flow (Dinic 1970) in whole numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.hpp"

namespace moldlight {

/// Finds for every node the side, 0 or 1, at which the sum of all costs is least.
class MinCut {
 public:
  explicit MinCut(std::size_t nodes) : costs_(nodes, {0.0, 0.0}) {}

  /// What it costs that a node is on a side; at least 0, finite.
  void add_cost(std::uint32_t node, int side, double cost) {
    costs_[node][static_cast<std::size_t>(side)] += cost;
  }
  /// What it costs that two nodes are on different sides; at least 0, finite.
  void add_link(std::uint32_t a, std::uint32_t b, double cost) { links_.push_back({a, b, cost}); }

  /// The sides; exact but for the rounding of costs to a 2^40th of the greatest. Of several best answers the
  /// one with the fewest nodes on side 0. Throws Cancelled.
  [[nodiscard]] std::vector<std::uint8_t> solve(const Progress& progress) const;

 private:
  struct Link {
    std::uint32_t a, b;
    double cost;
  };
  std::vector<std::array<double, 2>> costs_;
  std::vector<Link> links_;
};

}  // namespace moldlight
