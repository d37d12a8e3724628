// From what is known of surface samples to fractions and areas.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/facet_geometry.hpp"
#include "mold/region.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// What is known of a sample: a sum of these. The values are those in shaders/common.
namespace verdict {
inline constexpr std::uint8_t k_accessible_plus = 1;
inline constexpr std::uint8_t k_accessible_minus = 2;
}  // namespace verdict

[[nodiscard]] inline Region verdict_region(std::uint8_t bits) {
  return region_of((bits & verdict::k_accessible_plus) != 0, (bits & verdict::k_accessible_minus) != 0);
}

/// Shares of the samples, one verdict each in the order of `samples`.
[[nodiscard]] FacetFractions sampled_fractions(const SurfaceSamples& samples,
                                               std::span<const std::uint8_t> verdicts);

/// Model units squared.
[[nodiscard]] RegionValues region_areas(const FacetFractions& fractions, const FacetGeometry& geometry);

}  // namespace moldlight
