#include "bench/speed/contenders.hpp"

#include <algorithm>
#include <cmath>

#include "mold/sweep/ray_scorer.hpp"
#include "mold/sweep/scan_scorer.hpp"
#include "session/sweep/batch_scorer.hpp"
#include "session/sweep/map_scorer.hpp"

namespace moldlight::bench {

namespace {

constexpr double k_ray_exponent = 0.75;
constexpr double k_fewest_rays = 1000.0, k_most_rays = 4e6;

}  // namespace

Contenders::Contenders(const std::string& path, const BenchSettings& settings)
    : model_(load_part(path, {}, {})),
      scan_part_(model_->part.mesh, model_->geometry, model_->frame, model_->edges.concave) {
  truth_.directions = bench_directions(settings.uniform_directions);
  truth_.total_area = model_->geometry.total_area;
  truth_.undercuts = score_all(*ray_pool(settings.reference_samples, 0), truth_.directions);
  sample_sets_.clear();
}

std::unique_ptr<ScoringPool> Contenders::scan_pool(int resolution, double samples, int jobs) const {
  const ScanScorerSettings settings{
      .resolution = resolution, .tau_deg = k_tau_deg, .lateral = k_lateral, .samples = samples};
  return std::make_unique<ScoringPool>(
      [this, settings] {
        return std::make_unique<ScanScorer>(ScanScorerPart{scan_part_, model_->rays()}, settings);
      },
      jobs);
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

MethodSettings Contenders::gl_method(int resolution, int samples) const {
  MethodSettings method;
  method.tau_deg = k_tau_deg;
  method.resolution = resolution;
  method.samples = samples;
  method.tolerance = k_lateral * model_->frame.diagonal;
  return method;
}

std::unique_ptr<ScoringPool> Contenders::gl_pool(int resolution, int samples, int jobs) {
  const SurfaceSamples& set = sample_sets_.emplace_back(sample_surface_evenly(
      model_->part.mesh, model_->geometry, model_->frame, static_cast<std::uint64_t>(samples)));
  const BatchScorerSettings settings{
      .tau_deg = k_tau_deg, .map = map_settings(gl_method(resolution, samples), model_->frame.diagonal)};
  return std::make_unique<ScoringPool>(
      [this, &set, settings] {
        return std::make_unique<BatchScorer>(BatchScorerPart{model_, set}, settings);
      },
      jobs);
}

std::unique_ptr<ScoringPool> Contenders::gl_classifier_pool(int resolution, int samples, int jobs) const {
  return std::make_unique<ScoringPool>(
      [model = model_, method = gl_method(resolution, samples)] {
        return std::make_unique<MapScorer>(Backend::automatic, model, method);
      },
      jobs);
}

std::uint64_t Contenders::ray_samples_for(double error) {
  double log_sum = 0.0;
  int sets = 0;
  // Numbers that share no factor with the reference's, so that the samples are others.
  for (const std::uint64_t samples : {9'973, 29'989, 89'989}) {
    const double off = truth_.error(score_all(*ray_pool(samples, 0), truth_.directions));
    log_sum += std::log(std::max(off, 1e-9)) + k_ray_exponent * std::log(static_cast<double>(samples));
    ++sets;
  }
  const double wanted = std::exp((log_sum / sets - std::log(std::max(error, 1e-9))) / k_ray_exponent);
  return static_cast<std::uint64_t>(std::clamp(wanted, k_fewest_rays, k_most_rays));
}

}  // namespace moldlight::bench
