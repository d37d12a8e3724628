// The cheapest choice of columns that covers every atom.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"

namespace moldlight {

struct CoverColumn {
  std::vector<std::size_t> atoms;  // that it covers
  double cost = 1.0;               // > 0
};

/// Two columns that had better not be chosen together.
struct CoverClash {
  std::size_t a = 0, b = 0;  // columns, not the same
  double price = 1.0;        // >= 0, of choosing both
};

struct Cover {
  std::vector<std::size_t> columns;  // chosen, rising
  double cost = 0.0;                 // with the prices of clashes among them
  bool optimal = false;  // no choice is cheaper; false where the search was given up at a cover that it had
  std::vector<std::size_t> uncovered;  // atoms that no column has, rising
};

/// Branch and bound: atoms that one column alone has force it, columns that another covers at no more cost
/// and no further clash go; the atom with fewest columns is branched on, and atoms that share no column bound
/// the rest. Gives up after `most_nodes`. The same for the same input; of equal covers that with the earlier
/// columns. Of several clashes of the same two columns all count. Throws Cancelled.
[[nodiscard]] Cover least_cover(std::size_t atoms, std::span<const CoverColumn> columns,
                                std::span<const CoverClash> clashes = {}, std::size_t most_nodes = 200'000,
                                const Progress& progress = {});

}  // namespace moldlight
