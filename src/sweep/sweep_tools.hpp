// Tools that every stage of a sweep works with.
#pragma once

#include <functional>
#include <memory>

#include "classify/part_model.hpp"
#include "sweep/direction_actions.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/direction_rating.hpp"
#include "sweep/scoring_pools.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

struct SweepTools {
  /// All must outlive it but the model. Throws UsageError for settings that are not the method's.
  SweepTools(std::shared_ptr<const PartModel> part, const SweepSettings& sweep_settings,
             const Progress& progress, const SweepListener& noted);

  const PartModel& model;
  const SweepSettings& settings;
  SweepClock clock;
  const SweepListener& listener;
  DirectionRating rating;
  ScoringPools pools;
  DirectionMeasurer measurer;
  DirectionActionFinder actions;

  /// How many directions are listed.
  [[nodiscard]] std::size_t top() const { return static_cast<std::size_t>(settings.top); }
  /// How many are chosen by what is known before side actions are.
  [[nodiscard]] std::size_t wanted() const;
};

}  // namespace moldlight
