#include "session/sweep/map_scorer.hpp"

#include <algorithm>

#include "session/headless.hpp"

namespace moldlight {

MapScorer::MapScorer(Backend backend, std::shared_ptr<const PartModel> model, const MethodSettings& settings)
    : context_(create_context(backend)),
      classifier_(std::make_unique<Classifier>(*context_, std::move(model))),
      settings_(settings) {}

MapScorer::~MapScorer() {
  classifier_.reset();
  context_->release_current();
}

DirectionScore MapScorer::score(const glm::dvec3& direction) {
  settings_.direction = direction;
  Classification result = classifier_->start(settings_, Progress{});
  DirectionScore score;
  score.undercut_bound = std::max(0.0, result.projected.identity - result.projected.gap_limit);
  score.shadow_area = result.shadow_area;
  if (score.undercut_bound > limit()) {
    // Certain to be above the limit; the bound stands for the undercut, and nothing is known of the rest.
    score.given_up = true;
    score.areas[Region::undercut] = score.undercut_bound;
    score.undercut_error = result.total_area;
    return score;
  }
  classifier_->finish(result, Progress{});
  score.areas = result.areas;
  score.undercut_error = result.uncertainty.total;
  return score;
}

}  // namespace moldlight
