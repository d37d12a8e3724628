#include "bench/speed/contenders.hpp"

#include <glm/geometric.hpp>

#include "mold/exact/exact_regions.hpp"
#include "sweep/batch_scorer.hpp"
#include "sweep/ray_scorer.hpp"

namespace moldlight::bench {

Contenders::Contenders(const std::string& path, const BenchSettings& settings)
    : model_(load_part(path, {}, {})) {
  truth_.directions = bench_directions(settings.uniform_directions);
  truth_.total_area = model_->geometry.total_area;
  for (const glm::dvec3& direction : truth_.directions) truth_.undercuts.push_back(exact_undercut(direction));
}

double Contenders::exact_undercut(const glm::dvec3& direction) const {
  const ExactQuery query{.direction = glm::normalize(direction), .tau_deg = k_tau_deg, .lateral = k_lateral};
  return exact_areas(model_->exact({}), query, {}).areas[Region::undercut];
}

std::unique_ptr<ScoringPool> Contenders::ray_pool(std::uint64_t samples, int jobs) {
  const SurfaceSamples& set = sample_sets_.emplace_back(
      sample_surface_evenly(model_->part.mesh, model_->geometry, model_->frame, samples));
  return std::make_unique<ScoringPool>(
      [this, &set] {
        return std::make_unique<RayScorer>(RayScorerPart{model_->rays(), model_->geometry, set}, k_tau_deg,
                                           k_lateral);
      },
      jobs);
}

std::unique_ptr<ScoringPool> Contenders::gl_pool(int resolution, int samples, int jobs) {
  const SurfaceSamples& set = sample_sets_.emplace_back(sample_surface_evenly(
      model_->part.mesh, model_->geometry, model_->frame, static_cast<std::uint64_t>(samples)));
  const BatchScorerSettings settings{.tau_deg = k_tau_deg,
                                     .map = {.resolution = resolution, .lateral = k_lateral}};
  return std::make_unique<ScoringPool>(
      [this, &set, settings] {
        return std::make_unique<BatchScorer>(BatchScorerPart{model_, set}, settings);
      },
      jobs);
}

}  // namespace moldlight::bench
