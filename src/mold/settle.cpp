#include "mold/settle.hpp"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "base/check.hpp"
#include "mold/measure.hpp"

namespace moldlight {

namespace {

/// A prime, so that no pattern of facets and samples falls in step with it.
constexpr std::size_t k_audit_stride = 61;

constexpr std::size_t k_grain = 8192;  // samples a task

bool accessible_from_one_side(std::uint8_t bits) {
  return verdict_region(bits) == Region::core || verdict_region(bits) == Region::cavity;
}

}  // namespace

std::uint8_t ExactAnswers::of(const SurfaceSample& sample) const {
  const Accessibility accessibility = exact_accessibility(
      rays, sample.position, geometry.normals[sample.facet], classes[sample.facet], query);
  return static_cast<std::uint8_t>((accessibility.plus ? verdict::k_accessible_plus : 0) |
                                   (accessibility.minus ? verdict::k_accessible_minus : 0));
}

void settle_doubtful(const SurfaceSamples& samples, const ExactAnswers& exact,
                     std::span<std::uint8_t> verdicts, std::span<std::uint8_t> doubtful) {
  CHECK(verdicts.size() == samples.samples.size() && doubtful.size() == verdicts.size());
  const double steep_sine = std::sin(glm::radians(k_steep_deg));
  const auto doubt_unseen_by_maps = [&](const SurfaceSample& sample, std::uint8_t bits) {
    const glm::dvec3& normal = exact.geometry.normals[sample.facet];
    if (exact.classes[sample.facet] != FacetClass::near_vertical) {
      return std::abs(glm::dot(normal, exact.query.direction)) < steep_sine;
    }
    return accessible_from_one_side(bits) &&
           lateral_point_may_be_inside(exact.rays, sample.position, normal, exact.query);
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, verdicts.size(), k_grain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const SurfaceSample& sample = samples.samples[i];
      if (doubtful[i] == 0 && doubt_unseen_by_maps(sample, verdicts[i])) doubtful[i] = 1;
      if (doubtful[i] != 0) verdicts[i] = exact.of(sample);
    }
  });
}

Audit audit_undoubted(const SurfaceSamples& samples, const ExactAnswers& exact,
                      std::span<const std::uint8_t> verdicts, std::span<const std::uint8_t> doubtful) {
  CHECK(verdicts.size() == samples.samples.size() && doubtful.size() == verdicts.size());
  const std::size_t count = (verdicts.size() + k_audit_stride - 1) / k_audit_stride;
  std::vector<std::uint8_t> answers(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, k_grain / k_audit_stride),
                    [&](const auto& range) {
                      for (std::size_t k = range.begin(); k < range.end(); ++k) {
                        const std::size_t i = k * k_audit_stride;
                        if (doubtful[i] == 0) answers[k] = exact.of(samples.samples[i]);
                      }
                    });
  Audit audit;
  double variance = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = k * k_audit_stride;
    if (doubtful[i] != 0) continue;
    ++audit.audited;
    const Region is = verdict_region(answers[k]), given = verdict_region(verdicts[i]);
    if (is == given) continue;
    ++audit.wrong;
    if (is != Region::undercut && given != Region::undercut) continue;
    const FacetIndex facet = samples.samples[i].facet;
    const double weight = exact.geometry.areas[facet] * static_cast<double>(k_audit_stride) /
                          static_cast<double>(samples.first[facet + 1] - samples.first[facet]);
    audit.undercut_bias += is == Region::undercut ? weight : -weight;
    variance += weight * weight;
  }
  audit.undercut_error = std::sqrt(variance);
  return audit;
}

}  // namespace moldlight
