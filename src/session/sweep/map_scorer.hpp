// Scores directions by shadow maps on the GL as classify does, one at a time and with coarser settings:
// doubts are settled by exact rays, and the paper's own variants work too.
#pragma once

#include <memory>

#include "gl/context.hpp"
#include "mold/sweep/direction_scorer.hpp"
#include "session/classifier.hpp"

namespace moldlight {

/// Owns a context of its own, current on the thread that made the scorer.
class MapScorer : public DirectionScorer {
 public:
  MapScorer(Backend backend, std::shared_ptr<const PartModel> model, const MethodSettings& settings);
  ~MapScorer() override;

  [[nodiscard]] DirectionScore score(const glm::dvec3& direction) override;

 private:
  std::unique_ptr<gl::Context> context_;
  std::unique_ptr<Classifier> classifier_;
  MethodSettings settings_;
};

}  // namespace moldlight
