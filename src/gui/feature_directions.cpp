#include "gui/feature_directions.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "mold/candidates/find_candidates.hpp"

namespace moldlight::gui {

std::vector<FeatureDirection> feature_directions(const PartModel& model, const Progress& progress) {
  CandidateOptions options;
  options.kinds = {CandidateKind::axis, CandidateKind::revolution, CandidateKind::plane,
                   CandidateKind::perpendicular};
  options.most_per_kind = 12;
  options.merge_deg = 0.2;
  std::vector<FeatureDirection> features;
  for (const Candidate& candidate :
       find_candidates(model.part.mesh, model.geometry, model.adjacency, options, progress)) {
    features.push_back({candidate.direction, candidate.sources.front().reason});
  }
  return features;
}

glm::dvec3 snapped_to(const std::vector<FeatureDirection>& features, const glm::dvec3& direction) {
  glm::dvec3 best = direction;
  double best_cosine = 0.0;
  for (const FeatureDirection& feature : features) {
    const double cosine = glm::dot(feature.direction, direction);
    if (std::abs(cosine) <= best_cosine) continue;
    best_cosine = std::abs(cosine);
    best = cosine > 0.0 ? feature.direction : -feature.direction;
  }
  return best;
}

}  // namespace moldlight::gui
