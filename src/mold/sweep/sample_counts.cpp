#include "mold/sweep/sample_counts.hpp"

#include <cmath>
#include <numeric>

namespace moldlight {

void SampleCounts::add(const SampleCounts& other) {
  for (std::size_t k = 0; k < k_region_count; ++k) regions[k] += other.regions[k];
}

std::uint32_t SampleCounts::total() const {
  return std::accumulate(regions.begin(), regions.end(), std::uint32_t{0});
}

RegionValues SampleCounts::areas(double total_area) const {
  RegionValues areas;
  const double count = total();
  if (count <= 0.0) return areas;
  for (const Region region : k_regions)
    areas[region] = total_area * regions[static_cast<std::size_t>(region)] / count;
  return areas;
}

SampleCounts::Estimate SampleCounts::undercut(double total_area) const {
  const double count = total() + 2.0;
  const double share = (regions[static_cast<std::size_t>(Region::undercut)] + 1.0) / count;
  return {total_area * share, total_area * std::sqrt(share * (1.0 - share) / count)};
}

}  // namespace moldlight
