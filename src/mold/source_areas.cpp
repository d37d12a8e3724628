#include "mold/source_areas.hpp"

#include <algorithm>
#include <numeric>

#include "base/check.hpp"

namespace moldlight {

std::vector<SourceAreas> region_areas_by_source(std::span<const std::uint32_t> facet_sources,
                                                std::span<const double> facet_areas,
                                                const FacetFractions& fractions) {
  CHECK(facet_sources.size() == facet_areas.size() && facet_areas.size() == fractions.size());
  // Facets of one source stand together in most files, but not in all.
  std::vector<std::uint32_t> order(facet_sources.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return facet_sources[a] < facet_sources[b]; });
  std::vector<SourceAreas> sums;
  for (const std::uint32_t facet : order) {
    if (sums.empty() || sums.back().source != facet_sources[facet])
      sums.push_back({facet_sources[facet], {}});
    for (const Region region : k_regions) {
      sums.back().areas[region] += facet_areas[facet] * fractions[facet][static_cast<std::size_t>(region)];
    }
  }
  return sums;
}

}  // namespace moldlight
