#include "sweep/sweep_tools.hpp"

#include <utility>

#include "classify/method_options.hpp"

namespace moldlight {

namespace {

// A direction of more undercut often asks for fewer actions, but seldom one of far more; and each may take
// seconds.
constexpr std::size_t k_with_actions_per_listed = 2;

}  // namespace

SweepTools::SweepTools(std::shared_ptr<const PartModel> part, const SweepSettings& sweep_settings,
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

std::size_t SweepTools::wanted() const {
  return rating.by_actions() ? k_with_actions_per_listed * top() : top();
}

}  // namespace moldlight
