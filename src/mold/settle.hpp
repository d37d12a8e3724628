// Exact rays behind the maps: they settle the samples that the maps leave in doubt and audit some of the
// others.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/facet_geometry.hpp"
#include "mold/accessibility.hpp"
#include "mold/draft.hpp"
#include "mold/exact_rays.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// Up and down facets of less draft than this are always settled by rays: one texel of a map spans more than
/// eleven texels of their height.
inline constexpr double k_steep_deg = 5.0;

/// What the exact answer for a surface sample depends on. References must outlive it.
struct ExactAnswers {
  const ExactRays& rays;
  const FacetGeometry& geometry;
  std::span<const FacetClass> classes;  // one a facet, for the query's direction
  AccessibilityQuery query;

  /// Accessibility as verdict bits (mold/measure.hpp).
  [[nodiscard]] std::uint8_t of(const SurfaceSample& sample) const;
};

/// Replaces the verdict of every sample in doubt by the exact one. `doubtful` (one entry a sample, not 0 for
/// doubt) is what the maps said; samples whose doubt the maps cannot see are added to it: up and down facets
/// of little draft, and near-vertical ones whose lateral point may lie in the solid. Uses all cores; the
/// result does not depend on them.
void settle_doubtful(const SurfaceSamples& samples, const ExactAnswers& exact,
                     std::span<std::uint8_t> verdicts, std::span<std::uint8_t> doubtful);

/// Outcome of an audit. Areas in model units squared.
struct Audit {
  std::size_t audited = 0;
  std::size_t wrong = 0;
  double undercut_bias = 0.0;   // exact less given undercut area, extrapolated from the audited samples
  double undercut_error = 0.0;  // standard error of that
};

/// Checks every 61st sample that is not in doubt against exact rays.
[[nodiscard]] Audit audit_undoubted(const SurfaceSamples& samples, const ExactAnswers& exact,
                                    std::span<const std::uint8_t> verdicts,
                                    std::span<const std::uint8_t> doubtful);

}  // namespace moldlight
