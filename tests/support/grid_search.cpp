#include "support/grid_search.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "classify/classification.hpp"
#include "sweep/candidates/candidate_sources.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/ray_scorer.hpp"
#include "sweep/scoring.hpp"

namespace moldlight::test {

namespace {

constexpr std::uint64_t k_samples = 10'000;
constexpr std::size_t k_measured_together = 8;
constexpr double k_errors = 2.0;  // stated errors of a score within which a direction may be the best

}  // namespace

GridBest best_of_grid(const PartModel& model, std::size_t directions) {
  const MethodSettings settings;
  const double lateral = lateral_tolerance(settings, model.frame.diagonal) / model.frame.diagonal;
  const SurfaceSamples set = sample_surface_evenly(model.part.mesh, model.geometry, model.frame, k_samples);
  const RayScorerPart part{model.rays(), model.geometry, set};
  ScoringPool pool([&] { return std::make_unique<RayScorer>(part, settings.tau_deg, lateral); }, 0);
  std::vector<ScoringTask> tasks;
  for (const glm::dvec3& direction : fibonacci_half_sphere(directions))
    tasks.push_back({.direction = direction});
  const auto scores = pool.score(tasks, {}, {});
  std::vector<std::size_t> order(tasks.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a]->undercut() < scores[b]->undercut();
  });

  DirectionMeasurer measurer(model, settings, ScoringPool::threads(0));
  GridBest best{.undercut = std::numeric_limits<double>::infinity()};
  for (std::size_t next = 0; next < order.size();) {
    std::vector<ScoringTask> batch;
    for (; next < order.size() && batch.size() < k_measured_together; ++next) {
      const DirectionScore& score = *scores[order[next]];
      if (score.undercut() - k_errors * score.undercut_error <= best.undercut)
        batch.push_back({tasks[order[next]].direction, best.undercut});
    }
    for (const auto& measured : measurer.measure(batch, {}, Progress{}, [] { return false; })) {
      if (!measured) continue;
      const Classification& found = measured->classification;
      if (found.areas[Region::undercut] < best.undercut)
        best = {found.direction, found.areas[Region::undercut]};
    }
  }
  return best;
}

}  // namespace moldlight::test
