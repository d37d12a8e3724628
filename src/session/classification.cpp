#include "session/classification.hpp"

namespace moldlight {

Region dominant_region(const std::array<float, k_region_count>& fractions) {
  Region best = Region::undercut;
  for (const Region region : {Region::both, Region::cavity, Region::core}) {
    if (fractions[static_cast<std::size_t>(region)] > fractions[static_cast<std::size_t>(best)])
      best = region;
  }
  return best;
}

}  // namespace moldlight
