// What no sweep over maps can beat on a machine: the part streamed once and the maps written once a
// direction.
#pragma once

#include <cstdint>
#include <vector>

#include "mold/scan/scan_part.hpp"

namespace moldlight::bench {

/// One thread's share. Vertices are 16 bytes, facets 12; each of the two maps has 8 bytes a texel, a depth
/// and a facet.
class MachineLimit {
 public:
  MachineLimit(const ScanPart& part, int resolution);

  /// Reads every vertex and every facet and writes every texel; the result depends on all that was read.
  [[nodiscard]] std::uint64_t pass();

 private:
  const ScanPart& part_;
  std::vector<std::uint64_t> maps_[2];
  std::uint64_t passes_ = 0;
};

}  // namespace moldlight::bench
