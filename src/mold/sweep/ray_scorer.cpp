#include "mold/sweep/ray_scorer.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mold/draft.hpp"

namespace moldlight {

namespace {

/// Samples are asked in so many passes, each spread over the whole part and in the samples' own order, in
/// which neighbours follow each other.
constexpr std::size_t k_passes = 16;
constexpr double k_certain = 5.0;  // standard errors

/// Share of undercut samples and its standard error, as for independent samples, which even ones beat; one
/// more of either kind is counted, so that none seen is not none there.
struct UndercutShare {
  double share = 0.0, error = 0.0;

  [[nodiscard]] bool surely_above(double area, const RayScorerPart& part) const {
    return (share - k_certain * error) * part.geometry.total_area > area;
  }
};

UndercutShare undercut_of(const std::array<std::uint64_t, k_region_count>& counts, std::size_t seen) {
  const double total = static_cast<double>(seen) + 2.0;
  const double share =
      (static_cast<double>(counts[static_cast<std::size_t>(Region::undercut)]) + 1.0) / total;
  return {share, std::sqrt(share * (1.0 - share) / total)};
}

}  // namespace

RayScorer::RayScorer(const RayScorerPart& part, double tau_deg, double lateral)
    : part_(part), tau_deg_(tau_deg), lateral_(lateral) {}

void RayScorer::ask(std::size_t pass, const glm::dvec3& direction) {
  sample_rays_.begin({.direction = direction, .lateral = lateral_});
  const std::vector<SurfaceSample>& samples = part_.samples.samples;
  for (std::size_t i = pass; i < samples.size(); i += k_passes) {
    const SurfaceSample& sample = samples[i];
    const glm::dvec3& normal = part_.geometry.normals[sample.facet];
    sample_rays_.add(sample.position, normal, facet_class(normal, direction, tau_deg_),
                     glm::dot(normal, direction));
  }
  sample_rays_.ask(part_.rays);
}

void RayScorer::count(Tally& tally) const {
  sample_rays_.for_each([&](bool plus, bool minus, float facing) {
    ++tally.counts[static_cast<std::size_t>(region_of(plus, minus))];
    if (!(facing > 0.0F ? plus : minus)) tally.hidden += std::abs(static_cast<double>(facing));
    ++tally.seen;
  });
}

DirectionScore RayScorer::score(const glm::dvec3& direction) {
  Tally tally;
  DirectionScore score;
  for (std::size_t pass = 0; pass < k_passes && !score.given_up; ++pass) {
    ask(pass, direction);
    count(tally);
    score.given_up =
        pass + 1 < k_passes && undercut_of(tally.counts, tally.seen).surely_above(limit(), part_);
  }
  const double total_area = part_.geometry.total_area;
  const auto total = static_cast<double>(std::max<std::size_t>(tally.seen, 1));
  for (const Region region : k_regions) {
    score.areas[region] =
        total_area * static_cast<double>(tally.counts[static_cast<std::size_t>(region)]) / total;
  }
  score.undercut_error = 2.0 * total_area * undercut_of(tally.counts, tally.seen).error;
  double projected = 0.0;
  for (std::size_t facet = 0; facet < part_.geometry.areas.size(); ++facet) {
    projected += part_.geometry.areas[facet] * std::abs(glm::dot(part_.geometry.normals[facet], direction));
  }
  score.shadow_area = 0.5 * (projected - total_area * tally.hidden / total);
  return score;
}

SurfaceSamples sample_surface_evenly(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                     const UnitFrame& frame, std::uint64_t count) {
  SurfaceSamples set;
  set.first.reserve(mesh.facets.size() + 1);
  set.first.push_back(0);
  set.samples.reserve(count);
  double area_before = 0.0;
  const double step = geometry.total_area / static_cast<double>(std::max<std::uint64_t>(count, 1));
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const double area = geometry.areas[facet];
    const glm::dvec3& a = mesh.corner(facet, 0);
    const glm::dvec3 ab = mesh.corner(facet, 1) - a, ac = mesh.corner(facet, 2) - a;
    while (set.samples.size() < count &&
           (static_cast<double>(set.samples.size()) + 0.5) * step < area_before + area) {
      const TrianglePlace place = triangle_place(set.samples.size());
      set.samples.push_back({frame.to_unit(a + place.u * ab + place.v * ac), facet});
    }
    area_before += area;
    set.first.push_back(set.samples.size());
  }
  return set;
}

}  // namespace moldlight
