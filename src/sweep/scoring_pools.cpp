#include "sweep/scoring_pools.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "classify/classifier.hpp"
#include "classify/headless.hpp"
#include "sweep/batch_scorer.hpp"
#include "sweep/ray_scorer.hpp"

namespace moldlight {

namespace {

/// Maps of all threads' batches.
constexpr std::size_t k_map_bytes = 512U << 20;
/// One graphics card draws for one context at a time: two threads keep it at work, and with more it was seen
/// to take longer (by 1.4 with four, by 2.1 with eight).
constexpr int k_threads_on_a_card = 2;

}  // namespace

ScoringPools::ScoringPools(std::shared_ptr<const PartModel> model, const SweepSettings& settings)
    : model_(std::move(model)),
      settings_(settings),
      description_(settings.engine == SweepEngine::rays
                       ? fmt::format("rays ({} samples)", settings.scoring_samples)
                       : fmt::format("gl (maps of {} texels, {} samples)", settings.scoring_resolution,
                                     settings.scoring_samples)),
      samples_(sample_surface_evenly(model_->part.mesh, model_->geometry, model_->frame,
                                     static_cast<std::uint64_t>(settings.scoring_samples))) {}

ScoringPool& ScoringPools::engine() {
  if (settings_.engine == SweepEngine::rays) return rays();
  if (!gl_) gl_ = make_gl_pool();
  return *gl_;
}

ScoringPool& ScoringPools::rays() {
  if (!rays_) rays_ = std::make_unique<ScoringPool>([this] { return make_ray_scorer(); }, settings_.jobs);
  return *rays_;
}

double ScoringPools::lateral_share() const {
  return lateral_tolerance(settings_.method, model_->frame.diagonal) / model_->frame.diagonal;
}

std::unique_ptr<DirectionScorer> ScoringPools::make_ray_scorer() const {
  const RayScorerPart part{model_->rays(), model_->geometry, samples_};
  return std::make_unique<RayScorer>(part, settings_.method.tau_deg, lateral_share());
}

std::unique_ptr<ScoringPool> ScoringPools::make_gl_pool() const {
  const MethodSettings& method = settings_.method;
  int threads = ScoringPool::threads(settings_.jobs);
  if (settings_.jobs == 0) {
    const std::unique_ptr<gl::Context> context = create_context(method.backend);
    if (!context->draws_on_cpu()) threads = std::min(threads, k_threads_on_a_card);
    context->release_current();
  }
  // The lateral tolerance is what the final figures use, whatever the texel.
  BatchScorerSettings settings{.backend = method.backend,
                               .tau_deg = method.tau_deg,
                               .map = map_settings(method, model_->frame.diagonal),
                               .map_bytes = k_map_bytes / static_cast<std::size_t>(threads)};
  settings.map.lateral = lateral_share();
  settings.map.resolution = settings_.scoring_resolution;
  settings.map.symmetric_kernel = false;
  const BatchScorerPart part{model_, samples_};
  return std::make_unique<ScoringPool>([=] { return std::make_unique<BatchScorer>(part, settings); },
                                       threads);
}

}  // namespace moldlight
