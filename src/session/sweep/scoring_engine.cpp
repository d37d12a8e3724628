#include "session/sweep/scoring_engine.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mold/sweep/ray_scorer.hpp"
#include "mold/sweep/scan_scorer.hpp"
#include "mold/sweep/screened_scorer.hpp"
#include "session/sweep/batch_scorer.hpp"
#include "session/sweep/map_scorer.hpp"

namespace moldlight {

namespace {

/// Samples by which a direction is seen to be hopeless before it gets a map.
constexpr std::uint64_t k_glance_samples = 2000;

/// Maps of all threads' batches.
constexpr std::size_t k_map_bytes = 512U << 20;
/// One graphics card draws for one context at a time. A few threads suffice to classify facets and ask rays
/// meanwhile, and more would make the batches smaller.
constexpr int k_threads_on_a_card = 4;

}  // namespace

ScoringEngine::ScoringEngine(const Classifier& classifier, const SweepSettings& settings)
    : model_(classifier.shared_model()),
      settings_(settings),
      engine_(settings.engine),
      software_gl_(classifier.context().draws_on_cpu()) {
  const ScoringPlan plan = plan_for(settings_.scoring_samples);
  const bool closed = model_->health.closed;
  switch (engine_) {
    case SweepEngine::automatic:
      engine_ = plan.method == ScoringMethod::scan ? SweepEngine::cpu : SweepEngine::rays;
      description_ = (engine_ == SweepEngine::cpu ? "cpu (" : "rays (") +
                     (closed ? plan.reason() : std::string("the part is not closed")) + ")";
      break;
    case SweepEngine::gl:
      description_ = scores_in_batches()
                         ? fmt::format("gl (as asked; maps of {} texels, {} samples)",
                                       settings_.scoring_resolution, settings_.scoring_samples)
                         : "gl (as asked)";
      break;
    case SweepEngine::cpu:
      if (!closed) engine_ = SweepEngine::rays;
      description_ = closed ? "cpu (as asked)" : "rays (cpu was asked for, but the part is not closed)";
      break;
    case SweepEngine::rays:
      description_ = "rays (as asked)";
      break;
  }
}

ScoringPlan ScoringEngine::plan_for(int samples) const {
  return choose_engine(model_->part.mesh.facets.size(), ray_error(samples), model_->health.closed);
}

ScoringPool& ScoringEngine::pool() {
  if (!pool_) pool_ = scores_in_batches() ? make_batch_pool() : make_closer_pool(settings_.scoring_samples);
  return *pool_;
}

ScoringPool& ScoringEngine::same_samples_pool() {
  if (engine_ == SweepEngine::rays) return pool();
  if (!same_samples_pool_) same_samples_pool_ = make_same_samples_pool(settings_.scoring_samples);
  return *same_samples_pool_;
}

std::unique_ptr<ScoringPool> ScoringEngine::make_closer_pool(int samples) {
  if (engine_ == SweepEngine::gl) return make_gl_pool(samples);
  if (engine_ == SweepEngine::cpu) return make_scan_pool(plan_for(samples));
  return make_ray_pool(static_cast<std::uint64_t>(samples));
}

/// The paper's own variants have passes of their own, which know one direction.
bool ScoringEngine::scores_in_batches() const {
  return engine_ == SweepEngine::gl && settings_.method.kernel_shape == KernelShape::one_sided &&
         settings_.method.readout != Readout::facet_id;
}

MethodSettings ScoringEngine::gl_method() const {
  MethodSettings coarse = settings_.method;
  // The lateral tolerance stays what the final figures use, whatever the texel.
  coarse.tolerance = lateral_tolerance(settings_.method, model_->frame.diagonal);
  if (*coarse.tolerance <= 0.0) coarse.tolerance = std::nullopt;
  coarse.resolution = settings_.scoring_resolution;
  return coarse;
}

std::unique_ptr<ScoringPool> ScoringEngine::make_batch_pool() {
  int threads = ScoringPool::threads(settings_.jobs);
  if (settings_.jobs == 0 && !software_gl_) threads = std::min(threads, k_threads_on_a_card);
  const MethodSettings method = gl_method();
  const BatchScorerSettings settings{.backend = method.backend,
                                     .tau_deg = method.tau_deg,
                                     .map = map_settings(method, model_->frame.diagonal),
                                     .map_bytes = k_map_bytes / static_cast<std::size_t>(threads)};
  const BatchScorerPart part{model_, sample_set(static_cast<std::uint64_t>(settings_.scoring_samples))};
  return std::make_unique<ScoringPool>([=] { return std::make_unique<BatchScorer>(part, settings); },
                                       threads);
}

std::unique_ptr<ScoringPool> ScoringEngine::make_gl_pool(int samples) const {
  MethodSettings method = gl_method();
  method.samples = samples;
  return std::make_unique<ScoringPool>(
      [model = model_, method] { return std::make_unique<MapScorer>(method.backend, model, method); },
      settings_.jobs);
}

std::unique_ptr<ScoringPool> ScoringEngine::make_scan_pool(const ScoringPlan& plan) {
  if (!scan_part_) {
    scan_part_ = std::make_unique<const ScanPart>(model_->part.mesh, model_->geometry, model_->frame,
                                                  model_->edges.concave);
  }
  const ScanScorerPart part{*scan_part_, model_->rays()};
  const ScanScorerSettings scan{.resolution = plan.resolution,
                                .tau_deg = settings_.method.tau_deg,
                                .lateral = map_settings(settings_.method, model_->frame.diagonal).lateral,
                                .samples = plan.scan_samples};
  const RayScorerPart glance{model_->rays(), model_->geometry, sample_set(k_glance_samples)};
  return std::make_unique<ScoringPool>(
      [=] {
        return std::make_unique<ScreenedScorer>(
            std::make_unique<RayScorer>(glance, scan.tau_deg, scan.lateral),
            std::make_unique<ScanScorer>(part, scan));
      },
      settings_.jobs);
}

const SurfaceSamples& ScoringEngine::sample_set(std::uint64_t samples) {
  return sample_sets_.emplace_back(
      sample_surface_evenly(model_->part.mesh, model_->geometry, model_->frame, samples));
}

std::unique_ptr<ScoringPool> ScoringEngine::make_ray_pool(std::uint64_t samples) {
  const RayScorerPart part{model_->rays(), model_->geometry, sample_set(samples)};
  const double lateral = map_settings(settings_.method, model_->frame.diagonal).lateral;
  return std::make_unique<ScoringPool>(
      [=, tau_deg = settings_.method.tau_deg] { return std::make_unique<RayScorer>(part, tau_deg, lateral); },
      settings_.jobs);
}

}  // namespace moldlight
