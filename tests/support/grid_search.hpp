// The truth about the best parting direction, slowly: exact rays over an even set of directions.
#pragma once

#include <cstddef>

#include "session/classifier.hpp"

namespace moldlight::test {

struct GridBest {
  glm::dvec3 direction{0, 0, 1};
  double undercut = 0.0;     // as classify() measures it, model units squared
  double uncertainty = 0.0;  // of that
};

/// Scores `directions` evenly spread ones by exact rays, the best few of them again by many more rays, and
/// classifies the best of these with the default settings. Uses all cores.
[[nodiscard]] GridBest best_of_grid(Classifier& classifier, std::size_t directions);

}  // namespace moldlight::test
