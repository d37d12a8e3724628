// Which scorer is the fastest for an error: scan-converted maps or exact rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace moldlight {

enum class ScoringMethod : std::uint8_t { scan, rays };

/// A scorer's settings and what is to be expected of it. Errors are standard errors of the undercut area, as
/// shares of the part's area.
struct ScoringPlan {
  ScoringMethod method = ScoringMethod::scan;
  int resolution = 512;                 // of the maps
  double scan_samples = 30'000;         // ScanScorerSettings::samples
  double ray_samples = 100'000;         // of the whole part
  double scan_ms = 0.0, rays_ms = 0.0;  // expected time of a direction on one core, by either method

  /// The method and why, for the user.
  [[nodiscard]] std::string reason() const;
};

/// Error to expect of so many surface samples, each decided by exact rays.
[[nodiscard]] double ray_error(double samples);

/// The method that takes less time for this error. The rule, with figures from parts of 5,000 to 2,000,000
/// facets that the speed suite (tests/bench/speed) prints anew: a map costs by the facet and by the texel, a
/// ray by about the root of the facets; maps err as resolution^-1.25 and rays as samples^-0.75. So rays win
/// for a coarse look at any part and for a medium one at a large part. It depends on its arguments alone, so
/// that the same input gives the same output on every machine. `closed`: the part is; otherwise only rays
/// know what hides what.
[[nodiscard]] ScoringPlan choose_engine(std::size_t facets, double wanted_error, bool closed);

}  // namespace moldlight
