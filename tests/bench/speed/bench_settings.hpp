// How thorough a run of the speed suite is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace moldlight::bench {

struct BenchSettings {
  bool quick = false;        // one small part, little of everything: shows that the suite works, not how fast
  bool exact_alone = false;  // the exact regions' rows and no others
  int resolution = 512;      // of the maps
  std::vector<std::size_t> facets;
  std::size_t uniform_directions = 9;
  std::uint64_t reference_samples = 2'000'000;
  int rounds = 5;                                                // at least
  double seconds = 1.5;                                          // for a contest, at least
  std::vector<double> wanted_errors = {3e-3, 1e-3, 3e-4, 1e-4};  // shares of the part's area
};

}  // namespace moldlight::bench
