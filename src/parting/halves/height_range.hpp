// Between what heights something has to be.
#pragma once

#include <cmath>

namespace moldlight {

struct HeightRange {
  double low = -INFINITY, high = INFINITY;

  [[nodiscard]] bool empty() const { return low > high; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

}  // namespace moldlight
