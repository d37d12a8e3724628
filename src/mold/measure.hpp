// From what is known of the surface samples to fractions, areas and their errors.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/facet_geometry.hpp"
#include "mold/region.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// What is known of a sample: a sum of these. The values are those in shaders/common.
namespace verdict {
inline constexpr std::uint8_t k_accessible_plus = 1;
inline constexpr std::uint8_t k_accessible_minus = 2;
inline constexpr std::uint8_t k_doubtful = 4;           // the maps alone do not tell
inline constexpr std::uint8_t k_undercut_in_doubt = 8;  // nor whether it is accessible at all
}  // namespace verdict

[[nodiscard]] inline Region verdict_region(std::uint8_t bits) {
  return region_of((bits & verdict::k_accessible_plus) != 0, (bits & verdict::k_accessible_minus) != 0);
}

/// Error of the projected undercut by the identity of areas, from counting covered texels, as a share of the
/// part's area: within 0.1 % at 1024 texels and 0.35 % at 256 on real parts, falling with the texel's size.
[[nodiscard]] double shadow_error_share(int resolution);

/// Areas in model units squared.
struct Measurement {
  std::vector<std::array<float, k_region_count>> facet_fractions;  // a row a facet, sum 1; 0 without area
  RegionValues areas;
  double undercut_error = 0.0;            // standard error of the undercut area from sampling
  double projected_undercut = 0.0;        // area, projected along d, of surface hidden from both sides
  double projected_undercut_error = 0.0;  // its standard error
  double doubtful_area = 0.0;             // of samples still marked doubtful
};

/// One verdict a sample, in the order of `samples`. Standard errors are those of independent samples within
/// each facet (the samples are spread more evenly than that, so they are upper estimates); a facet on which
/// some sample was doubtful counts as if one more sample of either kind had been seen.
[[nodiscard]] Measurement measure(const SurfaceSamples& samples, std::span<const std::uint8_t> verdicts,
                                  const FacetGeometry& geometry, const glm::dvec3& direction,
                                  std::span<const std::uint8_t> was_doubtful);

}  // namespace moldlight
