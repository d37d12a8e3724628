// How thorough a run of the speed suite is.
#pragma once

#include <cstddef>
#include <vector>

namespace moldlight::bench {

struct BenchSettings {
  bool quick = false;        // one small part, little of everything: shows that the suite works, not how fast
  bool exact_alone = false;  // the exact regions' rows and no others
  int resolution = 512;      // of the maps
  std::vector<std::size_t> facets;
  std::size_t uniform_directions = 9;
  int rounds = 5;        // at least
  double seconds = 1.5;  // for a contest, at least
};

}  // namespace moldlight::bench
