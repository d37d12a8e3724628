#include "mold/measure.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace moldlight {

FacetFractions sampled_fractions(const SurfaceSamples& samples, std::span<const std::uint8_t> verdicts) {
  CHECK(verdicts.size() == samples.samples.size());
  FacetFractions fractions(samples.first.size() - 1);
  for (std::size_t facet = 0; facet < fractions.size(); ++facet) {
    const std::uint64_t first = samples.first[facet], last = samples.first[facet + 1];
    std::array<std::uint64_t, k_region_count> counts{};
    for (std::uint64_t i = first; i < last; ++i) {
      ++counts[static_cast<std::size_t>(verdict_region(verdicts[i]))];
    }
    for (std::size_t region = 0; region < k_region_count && last > first; ++region) {
      fractions[facet][region] = static_cast<double>(counts[region]) / static_cast<double>(last - first);
    }
  }
  return fractions;
}

RegionValues region_areas(const FacetFractions& fractions, const FacetGeometry& geometry) {
  CHECK(fractions.size() == geometry.areas.size());
  RegionValues areas;
  for (std::size_t facet = 0; facet < fractions.size(); ++facet) {
    for (const Region region : k_regions) {
      areas[region] += geometry.areas[facet] * fractions[facet][static_cast<std::size_t>(region)];
    }
  }
  return areas;
}

}  // namespace moldlight
