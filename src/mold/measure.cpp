#include "mold/measure.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

struct Counts {
  std::array<std::uint64_t, k_region_count> region{};
  std::uint64_t hidden = 0;  // not accessible along the side that the facet faces
  std::uint64_t doubtful = 0;
  bool had_doubt = false;
};

/// Variance of a share estimated from `hits` of `count` samples.
double share_variance(std::uint64_t hits, std::uint64_t count, bool had_doubt) {
  const double extra = had_doubt ? 1.0 : 0.0;
  const double seen = static_cast<double>(count) + 2.0 * extra;
  const double share = (static_cast<double>(hits) + extra) / seen;
  return share * (1.0 - share) / seen;
}

}  // namespace

double shadow_error_share(int resolution) { return 1e-3 * std::max(1.0, 1024.0 / resolution); }

Measurement measure(const SurfaceSamples& samples, std::span<const std::uint8_t> verdicts,
                    const FacetGeometry& geometry, const glm::dvec3& direction,
                    std::span<const std::uint8_t> was_doubtful) {
  CHECK(verdicts.size() == samples.samples.size() && was_doubtful.size() == verdicts.size());
  const std::size_t facets = geometry.areas.size();
  Measurement result;
  result.facet_fractions.resize(facets);
  double undercut_variance = 0.0, projected_variance = 0.0;
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const std::uint64_t count = samples.first[facet + 1] - samples.first[facet];
    if (count == 0) continue;
    const double facing = glm::dot(geometry.normals[facet], direction);
    const std::uint8_t facing_bit = facing > 0.0 ? verdict::k_accessible_plus : verdict::k_accessible_minus;
    Counts counts;
    for (std::uint64_t i = samples.first[facet]; i < samples.first[facet + 1]; ++i) {
      ++counts.region[static_cast<std::size_t>(verdict_region(verdicts[i]))];
      counts.hidden += (verdicts[i] & facing_bit) == 0 ? 1 : 0;
      counts.doubtful += (verdicts[i] & verdict::k_doubtful) != 0 ? 1 : 0;
      counts.had_doubt = counts.had_doubt || was_doubtful[i] != 0;
    }
    const double area = geometry.areas[facet];
    const double per_sample = 1.0 / static_cast<double>(count);
    for (const Region region : k_regions) {
      const auto index = static_cast<std::size_t>(region);
      const double share = static_cast<double>(counts.region[index]) * per_sample;
      result.facet_fractions[facet][index] = static_cast<float>(share);
      result.areas[region] += area * share;
    }
    const double projected = area * std::abs(facing);
    result.projected_undercut += projected * static_cast<double>(counts.hidden) * per_sample;
    result.doubtful_area += area * static_cast<double>(counts.doubtful) * per_sample;
    const std::uint64_t undercut = counts.region[static_cast<std::size_t>(Region::undercut)];
    undercut_variance += area * area * share_variance(undercut, count, counts.had_doubt);
    projected_variance += projected * projected * share_variance(counts.hidden, count, counts.had_doubt);
  }
  result.undercut_error = std::sqrt(undercut_variance);
  result.projected_undercut_error = std::sqrt(projected_variance);
  return result;
}

}  // namespace moldlight
