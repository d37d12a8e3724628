#include "mold/measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.hpp"
#include "mold/draft.hpp"

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

double near_vertical_area(const FacetGeometry& geometry, const glm::dvec3& direction, double tau_deg) {
  double area = 0.0;
  for (std::size_t facet = 0; facet < geometry.areas.size(); ++facet) {
    if (facet_class(geometry.normals[facet], direction, tau_deg) == FacetClass::near_vertical)
      area += geometry.areas[facet];
  }
  return area;
}

ReverseDraft reverse_draft(const FacetFractions& fractions, const FacetGeometry& geometry,
                           const glm::dvec3& direction) {
  ReverseDraft reverse;
  for (FacetIndex facet = 0; facet < fractions.size(); ++facet) {
    const double draft = draft_angle_deg(geometry.normals[facet], direction);
    if (std::abs(draft) <= k_draft_rounding_deg) continue;
    const Region leaning = draft < 0.0 ? Region::core : Region::cavity;
    const double share = fractions[facet][static_cast<std::size_t>(leaning)];
    if (share <= 0.0) continue;
    reverse.area += share * geometry.areas[facet];
    if (std::abs(draft) <= reverse.worst_deg) continue;
    reverse.worst_deg = std::abs(draft);
    reverse.facet = facet;
  }
  return reverse;
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

std::vector<SourceAreas> region_areas_by_source(std::span<const std::uint32_t> facet_sources,
                                                std::span<const double> facet_areas,
                                                const FacetFractions& fractions) {
  CHECK(facet_sources.size() == facet_areas.size() && facet_areas.size() == fractions.size());
  // Facets of one source stand together in most files, but not in all.
  std::vector<std::uint32_t> order(facet_sources.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t facet) { return facet_sources[facet]; });
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
