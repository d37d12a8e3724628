// The choice of how directions are scored, and the pools that do it.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "mold/scan/scan_part.hpp"
#include "mold/surface_samples.hpp"
#include "mold/sweep/engine_choice.hpp"
#include "session/classifier.hpp"
#include "session/sweep/scoring.hpp"
#include "session/sweep/sweep_settings.hpp"

namespace moldlight {

class ScoringEngine {
 public:
  ScoringEngine(const Classifier& classifier, const SweepSettings& settings);

  /// The engine taken and why, for the user.
  [[nodiscard]] const std::string& description() const { return description_; }
  /// The pool for ranking many directions; the same at every call.
  [[nodiscard]] ScoringPool& pool();
  /// A pool for telling near directions from each other: it asks exact rays from the same surface samples for
  /// every direction. The same at every call.
  [[nodiscard]] ScoringPool& same_samples_pool();
  /// Such a pool with so many samples. Must not outlive the engine.
  [[nodiscard]] std::unique_ptr<ScoringPool> make_same_samples_pool(int samples) {
    return make_ray_pool(static_cast<std::uint64_t>(samples));
  }
  /// A pool that scores few directions closer, by `samples` surface samples. Must not outlive the engine.
  [[nodiscard]] std::unique_ptr<ScoringPool> make_closer_pool(int samples);

 private:
  [[nodiscard]] ScoringPlan plan_for(int samples) const;
  [[nodiscard]] bool scores_in_batches() const;
  [[nodiscard]] MethodSettings gl_method() const;
  [[nodiscard]] std::unique_ptr<ScoringPool> make_batch_pool();
  [[nodiscard]] std::unique_ptr<ScoringPool> make_gl_pool(int samples) const;
  [[nodiscard]] std::unique_ptr<ScoringPool> make_scan_pool(const ScoringPlan& plan);
  [[nodiscard]] std::unique_ptr<ScoringPool> make_ray_pool(std::uint64_t samples);

  [[nodiscard]] const SurfaceSamples& sample_set(std::uint64_t samples);

  std::shared_ptr<const PartModel> model_;
  const SweepSettings& settings_;
  SweepEngine engine_ = SweepEngine::rays;
  bool software_gl_;
  std::string description_;
  std::deque<SurfaceSamples> sample_sets_;  // of the pools; their places do not change
  std::unique_ptr<const ScanPart> scan_part_;
  std::unique_ptr<ScoringPool> pool_, same_samples_pool_;
};

}  // namespace moldlight
