// The cheapest choice of options that covers every undercut part.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"

namespace moldlight {

struct CoverOption {
  std::vector<std::size_t> undercut_parts;  // that it covers
  double cost = 1.0;                        // > 0
};

/// Two options that had better not be chosen together.
struct CoverClash {
  std::size_t a = 0, b = 0;  // options, not the same
  double price = 1.0;        // >= 0, of choosing both
};

struct Cover {
  std::vector<std::size_t> options;  // chosen, rising
  double cost = 0.0;                 // with the prices of clashes among them
  bool optimal = false;  // no choice is cheaper; false where the search was given up at a cover that it had
  std::vector<std::size_t> uncovered;  // undercut parts that no option has, rising
};

/// Branch and bound: undercut parts that one option alone has force it, options that another covers at no
/// more cost and no further clash go; the undercut part with fewest options is branched on, and undercut
/// parts that share no option bound the rest. Gives up after `most_nodes`. The same for the same input; of
/// equal covers that with the earlier options. Of several clashes of the same two options all count. Throws
/// Cancelled.
[[nodiscard]] Cover least_cover(std::size_t undercut_parts, std::span<const CoverOption> options,
                                std::span<const CoverClash> clashes = {}, std::size_t most_nodes = 200'000,
                                const Progress& progress = {});

}  // namespace moldlight
