// Disjoint sets of numbers 0 … n-1; the lowest member stands for its set, so results do not depend on joining
// order.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace moldlight {

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  /// Lowest member of the set that `item` is in.
  [[nodiscard]] std::uint32_t find(std::uint32_t item) {
    while (parent_[item] != item) {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace moldlight
