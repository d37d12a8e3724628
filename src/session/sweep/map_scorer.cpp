#include "session/sweep/map_scorer.hpp"

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
  const Classification result = classifier_->classify(settings_, Progress{});
  DirectionScore score;
  score.areas = result.areas;
  score.undercut_error = result.uncertainty.total();
  score.shadow_area = result.shadow_area;
  return score;
}

}  // namespace moldlight
