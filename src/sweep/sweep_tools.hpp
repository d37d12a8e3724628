// Tools that every stage of a sweep works with.
#pragma once

#include <memory>
#include <utility>

#include "classify/method_options.hpp"
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
             const Progress& progress, const SweepListener& noted)
      : model(*part),
        settings(sweep_settings),
        clock(progress, settings.time_limit_s),
        listener(noted),
        rating(model, settings),
        pools(std::move(part), settings),
        measurer(model, settings.method, ScoringPool::threads(settings.jobs), rating.beside()),
        actions(model, settings.method, settings.action_settings, ScoringPool::threads(settings.jobs)) {
    validate(settings.method, model.frame.diagonal);
  }

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
  /// How many are chosen by what is known before side actions are: a direction of more undercut often asks
  /// for fewer actions, but seldom one of far more; and each may take seconds.
  [[nodiscard]] std::size_t wanted() const { return rating.by_actions() ? 2 * top() : top(); }
};

}  // namespace moldlight
