// The threads that score a sweep's directions, by the engine that the settings name.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "classify/part_model.hpp"
#include "mold/surface_samples.hpp"
#include "sweep/scoring.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight {

class ScoringPools {
 public:
  ScoringPools(std::shared_ptr<const PartModel> model, const SweepSettings& settings);

  /// The engine and its settings, for the user.
  [[nodiscard]] const std::string& description() const { return description_; }
  /// For ranking many directions.
  [[nodiscard]] ScoringPool& engine();
  /// For distinguishing near directions: exact rays from the same surface samples for every
  /// direction.
  [[nodiscard]] ScoringPool& rays();
  /// One of the scorers of rays(), for a thread of the caller's.
  [[nodiscard]] std::unique_ptr<DirectionScorer> make_ray_scorer() const;

 private:
  /// The lateral tolerance by the part's diagonal.
  [[nodiscard]] double lateral_share() const;
  [[nodiscard]] std::unique_ptr<ScoringPool> make_gl_pool() const;

  std::shared_ptr<const PartModel> model_;
  const SweepSettings& settings_;
  std::string description_;
  SurfaceSamples samples_;
  std::unique_ptr<ScoringPool> gl_, rays_;
};

}  // namespace moldlight
