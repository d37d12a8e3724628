// What sizes are put into order by, where they may be alike.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace moldlight {

/// Grows with a size (0 or more), and is the same for sizes that rounding alone distinguishes: the logarithm
/// in millionths.
[[nodiscard]] inline std::int64_t size_key(double size) {
  constexpr double k_steps = 1e6, k_least = 1e-300;
  return std::llround(k_steps * std::log(std::max(size, k_least)));
}

}  // namespace moldlight
