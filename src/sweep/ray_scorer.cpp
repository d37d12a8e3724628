#include "sweep/ray_scorer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>

#include "mold/draft.hpp"

namespace moldlight {

namespace {

/// Samples are asked in passes, each spread over the whole part and in the samples' own order, in which
/// neighbours follow each other: few at first, then more, since rays that are asked together share what they
/// touch.
struct Pass {
  std::size_t first, step;
};
constexpr std::array<Pass, 5> k_passes = {{{0, 16}, {8, 16}, {4, 8}, {2, 4}, {1, 2}}};
constexpr double k_certain = 5.0, k_certain_beside = 3.0;  // standard errors

}  // namespace

RayScorer::RayScorer(const RayScorerPart& part, double tau_deg, double lateral)
    : part_(part), sine_of_tau_(std::sin(glm::radians(tau_deg))), lateral_(lateral) {}

void RayScorer::ask(std::size_t first, std::size_t step, const glm::dvec3& direction) {
  sample_rays_.begin({.direction = direction, .lateral = lateral_});
  const std::vector<SurfaceSample>& samples = part_.samples.samples;
  for (std::size_t i = first; i < samples.size(); i += step) {
    const SurfaceSample& sample = samples[i];
    const glm::dvec3& normal = part_.geometry.normals[sample.facet];
    sample_rays_.add(i, sample.position, normal, facet_class(glm::dot(normal, direction), sine_of_tau_));
  }
  sample_rays_.ask(part_.rays);
}

void RayScorer::count(const ScoringTask& task, Tally& tally) const {
  sample_rays_.for_each([&](std::size_t number, bool plus, bool minus, float facing) {
    const Region region = region_of(plus, minus);
    ++tally.counts.regions[static_cast<std::size_t>(region)];
    if (!(facing > 0.0F ? plus : minus)) tally.hidden += std::abs(static_cast<double>(facing));
    tally.undercut[number] = region == Region::undercut;
    if (task.beside == nullptr) return;
    const bool beside = (*task.beside->undercut_samples)[number];
    tally.more += tally.undercut[number] && !beside ? 1 : 0;
    tally.fewer += !tally.undercut[number] && beside ? 1 : 0;
  });
}

RayScorer::Side RayScorer::surely_on_side(const ScoringTask& task, const Tally& tally) const {
  const double total_area = part_.geometry.total_area;
  if (task.beside == nullptr) {
    const SampleCounts::Estimate undercut = tally.counts.undercut(total_area);
    return undercut.area - k_certain * undercut.error > task.give_up_above ? Side::above : Side::unknown;
  }
  const auto more = static_cast<double>(tally.more), fewer = static_cast<double>(tally.fewer);
  const double allowed = (task.give_up_above - task.beside->undercut()) / total_area * tally.counts.total();
  const double beyond = more - fewer - allowed, error = k_certain_beside * std::sqrt(more + fewer + 1.0);
  if (beyond > error) return Side::above;
  return task.side_only && -beyond > error ? Side::below : Side::unknown;
}

std::vector<DirectionScore> RayScorer::score(std::span<const ScoringTask> tasks) {
  std::vector<DirectionScore> scores;
  for (const ScoringTask& task : tasks) scores.push_back(score_one(task));
  return scores;
}

DirectionScore RayScorer::score_one(const ScoringTask& task) {
  Tally tally;
  tally.undercut.resize(part_.samples.samples.size());
  DirectionScore score;
  Side side = Side::unknown;
  for (const Pass& pass : k_passes) {
    ask(pass.first, pass.step, task.direction);
    count(task, tally);
    if (tally.counts.total() < part_.samples.samples.size()) side = surely_on_side(task, tally);
    if (side != Side::unknown) break;
  }
  score.given_up = side == Side::above;
  const double total_area = part_.geometry.total_area;
  const double total = std::max(tally.counts.total(), 1U);
  score.areas = tally.counts.areas(total_area);
  // Of few samples the difference says more than the share.
  if (side != Side::unknown && task.beside != nullptr)
    score.areas[Region::undercut] =
        task.beside->undercut() +
        total_area * (static_cast<double>(tally.more) - static_cast<double>(tally.fewer)) / total;
  score.undercut_error = 2.0 * tally.counts.undercut(total_area).error;
  // Nobody asks that of a direction that was only compared.
  if (side == Side::unknown || task.beside == nullptr)
    score.shadow_area =
        0.5 * (projected_area(part_.geometry, task.direction) - total_area * tally.hidden / total);
  if (side == Side::unknown)
    score.undercut_samples = std::make_shared<const std::vector<bool>>(std::move(tally.undercut));
  return score;
}

}  // namespace moldlight
