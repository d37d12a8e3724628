// The truth about the best parting direction, slowly: an even set of directions, the best by exact regions.
#pragma once

#include <cstddef>
#include <memory>

#include "classify/part_model.hpp"

namespace moldlight::test {

struct GridBest {
  glm::dvec3 direction{0, 0, 1};
  double undercut = 0.0;  // as classify() measures it, model units squared
};

/// Scores `directions` evenly spread ones by rays and measures all of them that may be the best, with the
/// default settings. Uses all cores.
[[nodiscard]] GridBest best_of_grid(const PartModel& model, std::size_t directions);

}  // namespace moldlight::test
