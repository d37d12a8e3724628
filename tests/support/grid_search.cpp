#include "support/grid_search.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "mold/candidates/candidate_sources.hpp"
#include "mold/sweep/ray_scorer.hpp"
#include "session/sweep/scoring.hpp"

namespace moldlight::test {

namespace {

constexpr std::uint64_t k_coarse_samples = 10'000, k_fine_samples = 200'000;
constexpr std::size_t k_scored_again = 30;

/// Indices into `directions`, least undercut first.
std::vector<std::size_t> order_by_rays(const PartModel& model, const std::vector<glm::dvec3>& directions,
                                       std::uint64_t samples) {
  const MethodSettings settings;
  const double lateral = map_settings(settings, model.frame.diagonal).lateral;
  const SurfaceSamples set = sample_surface_evenly(model.part.mesh, model.geometry, model.frame, samples);
  const RayScorerPart part{model.rays(), model.geometry, set};
  ScoringPool pool([&] { return std::make_unique<RayScorer>(part, settings.tau_deg, lateral); }, 0);
  std::vector<ScoringTask> tasks;
  for (const glm::dvec3& direction : directions) tasks.push_back({.direction = direction});
  const auto scores = pool.score(tasks, [] { return false; }, {});
  std::vector<std::size_t> order(directions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a].value().undercut() < scores[b].value().undercut();
  });
  return order;
}

}  // namespace

GridBest best_of_grid(Classifier& classifier, std::size_t directions) {
  const PartModel& model = classifier.model();
  const std::vector<glm::dvec3> grid = fibonacci_half_sphere(directions);
  std::vector<glm::dvec3> best;
  for (const std::size_t i : order_by_rays(model, grid, k_coarse_samples)) {
    best.push_back(grid[i]);
    if (best.size() == k_scored_again) break;
  }
  MethodSettings settings;
  settings.direction = best[order_by_rays(model, best, k_fine_samples).front()];
  const Classification result = classifier.classify(settings, Progress{});
  return {result.direction, result.areas[Region::undercut], result.uncertainty.total()};
}

}  // namespace moldlight::test
