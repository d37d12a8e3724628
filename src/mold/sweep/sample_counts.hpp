// From counts of evenly spread surface samples to areas and the error of the undercut.
#pragma once

#include <array>
#include <cstdint>

#include "mold/region.hpp"

namespace moldlight {

/// Samples of equal weight, as sample_surface_evenly() gives them, counted here or by shaders/measure. A
/// stratum is k_stratum of them one after the other, of which c are counted and u of those are undercut.
struct SampleCounts {
  static constexpr std::uint32_t k_stratum = 16;

  std::array<std::uint32_t, k_region_count> regions{};
  std::uint32_t undercut_in_doubt = 0;  // a texel beside says otherwise
  /// Sum over the strata of k_stratum u (c - u) / c, rounded up; where some undercut is in doubt as if one
  /// more sample of either kind had been counted.
  std::uint32_t spread = 0;

  /// A stratum's counts without doubt.
  void add_stratum(const std::array<std::uint32_t, k_region_count>& counted);
  void add(const SampleCounts& other);

  [[nodiscard]] std::uint64_t total() const;
  [[nodiscard]] RegionValues areas(double total_area) const;
  /// Of the undercut area at the 95 % level: twice the standard error of samples that are independent within
  /// their strata, which even ones beat, one more of either kind counted over the part; and a share of the
  /// area in doubt that on real parts covers what proves wrong.
  [[nodiscard]] double undercut_error(double total_area) const;
};

}  // namespace moldlight
