// The middle of several measurements, which a few disturbed ones do not move.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace moldlight {

/// Median of values, the mean of the middle two of an even number; 0 of none.
[[nodiscard]] inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace moldlight
