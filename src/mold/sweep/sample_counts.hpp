// From counts of evenly spread surface samples to areas and the error of the undercut.
#pragma once

#include <array>
#include <cstdint>

#include "mold/region.hpp"

namespace moldlight {

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
