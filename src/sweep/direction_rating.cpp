#include "sweep/direction_rating.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace moldlight {

DirectionRating::DirectionRating(const PartModel& model, const SweepSettings& settings)
    : model_(model),
      settings_(settings),
      measure_{std::max(model.geometry.total_area, std::numeric_limits<double>::min()),
               model.frame.diagonal} {
  // Files may hold vertices that no facet uses.
  const TriangleMesh& mesh = model.part.mesh;
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) {
      if (used[vertex]) continue;
      used[vertex] = true;
      corners_.push_back(mesh.vertices[vertex] - model.frame.center);
    }
  }
  for (const Objective::Term& term : settings.objective.terms) {
    if (term.figure == &direction_figure("undercut")) {
      undercut_weight_ += term.weight;
    } else {
      by_undercut_alone_ = false;
    }
    if (term.figure == &direction_figure("parting_climb") ||
        term.figure == &direction_figure("parting_length"))
      by_parting_ = true;
  }
}

Classification DirectionRating::classification(const glm::dvec3& direction,
                                               const DirectionScore& score) const {
  Classification told;
  told.settings = settings_.method;
  told.direction = direction;
  told.areas = score.areas;
  told.total_area = model_.geometry.total_area;
  told.shadow_area = score.shadow_area;
  told.uncertainty.readout = score.undercut_error;
  return told;
}

DirectionFacts DirectionRating::facts(const Classification& classification,
                                      const MeasuredDirection* measured) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const glm::dvec3& corner : corners_) {
    const double height = glm::dot(corner, classification.direction);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return {.model = model_,
          .settings = settings_,
          .classification = classification,
          .draw_depth = high >= low ? high - low : 0.0,
          .measured = measured != nullptr,
          .patches = measured != nullptr ? std::optional(measured->patches) : std::nullopt,
          .parting = measured != nullptr ? measured->parting : std::nullopt};
}

RankedFigures DirectionRating::ranked(const Candidate& candidate, const DirectionFacts& facts,
                                      double undercut_uncertainty) const {
  return {.value = objective_value(settings_.objective, facts),
          .value_uncertainty = value_of_undercut(undercut_uncertainty),
          .undercut = facts.classification.areas[Region::undercut],
          .undercut_uncertainty = undercut_uncertainty,
          .patches = static_cast<double>(facts.patches.value_or(0)),
          .draw_depth = facts.draw_depth,
          .projected_area = facts.classification.shadow_area,
          .exact = candidate.exact()};
}

RankedFigures DirectionRating::scored(const Candidate& candidate, const DirectionScore& score) const {
  const Classification told = classification(candidate.direction, score);
  // What is known of a direction given up is that it is worse: it ties with nothing.
  return ranked(candidate, facts(told, nullptr), score.given_up ? 0.0 : score.undercut_error);
}

RankedFigures DirectionRating::measured(const Candidate& candidate, const MeasuredDirection& measured,
                                        bool with_patches) const {
  DirectionFacts found = facts(measured.classification, &measured);
  if (!with_patches) found.patches.reset();
  return ranked(candidate, found, measured.classification.uncertainty.rounding);
}

}  // namespace moldlight
