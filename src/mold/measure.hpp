// From what is known of surface samples and facets to fractions and areas.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
}  // namespace verdict

[[nodiscard]] inline Region verdict_region(std::uint8_t bits) {
  return region_of((bits & verdict::k_accessible_plus) != 0, (bits & verdict::k_accessible_minus) != 0);
}

/// Shares of the samples, one verdict each in the order of `samples`.
[[nodiscard]] FacetFractions sampled_fractions(const SurfaceSamples& samples,
                                               std::span<const std::uint8_t> verdicts);

/// Area of the facets with less draft than tau (degrees) along a unit direction, model units squared.
[[nodiscard]] double near_vertical_area(const FacetGeometry& geometry, const glm::dvec3& direction,
                                        double tau_deg);

/// Draft angles that coordinates of a file in single precision cannot distinguish, degrees.
inline constexpr double k_draft_rounding_deg = 1e-3;

/// Near-vertical surface that one half alone reaches and that leans against it by more than rounding.
struct ReverseDraft {
  double area = 0.0;                // model units squared
  double worst_deg = 0.0;           // the greatest lean; 0 where there is none
  std::optional<FacetIndex> facet;  // that leans so
};
[[nodiscard]] ReverseDraft reverse_draft(const FacetFractions& fractions, const FacetGeometry& geometry,
                                         const glm::dvec3& direction);

/// Model units squared.
[[nodiscard]] RegionValues region_areas(const FacetFractions& fractions, const FacetGeometry& geometry);

struct SourceAreas {
  std::uint32_t source = 0;  // number of the CAD face or polygon
  RegionValues areas;        // model units squared
};

/// Sums facet areas by source; one entry a facet in each span. Sources in ascending order, those that no
/// facet has left out.
[[nodiscard]] std::vector<SourceAreas> region_areas_by_source(std::span<const std::uint32_t> facet_sources,
                                                              std::span<const double> facet_areas,
                                                              const FacetFractions& fractions);

/// Samples of equal weight, as sample_surface_evenly() gives them, by region.
struct SampleCounts {
  std::array<std::uint32_t, k_region_count> regions{};

  void add(const SampleCounts& other);
  [[nodiscard]] std::uint32_t total() const;
  [[nodiscard]] RegionValues areas(double total_area) const;
  /// Undercut area and its standard error, as for independent samples, which even ones beat; one more of
  /// either kind is counted, so that none seen is not none there.
  struct Estimate {
    double area = 0.0, error = 0.0;
  };
  [[nodiscard]] Estimate undercut(double total_area) const;
};

}  // namespace moldlight
