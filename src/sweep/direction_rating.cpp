#include "sweep/direction_rating.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

double weight_of_undercut(const Objective& objective) {
  double weight = 0.0;
  for (const Objective::Term& term : objective.terms) {
    if (term.figure == &direction_figure("undercut")) weight += term.weight;
  }
  return weight;
}

}  // namespace

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
  beside_.least_travel_mm = settings.action_settings.least_travel_mm;
  by_actions_ = needs_actions(settings.objective);
  before_actions_ = settings.objective;
  for (Objective::Term& term : before_actions_.terms) {
    if (term.figure->use.of_actions) term.figure = &direction_figure("undercut");
    by_undercut_alone_ = by_undercut_alone_ && term.figure == &direction_figure("undercut");
    if (term.figure == &direction_figure("undercuts")) beside_.undercuts = true;
    if (term.figure == &direction_figure("parting_climb") ||
        term.figure == &direction_figure("parting_length"))
      beside_.parting = true;
  }
  undercut_weight_ = weight_of_undercut(before_actions_);
}

Classification DirectionRating::classification(const glm::dvec3& direction,
                                               const DirectionScore& score) const {
  Classification noted;
  noted.settings = settings_.method;
  noted.direction = direction;
  noted.areas = score.areas;
  noted.total_area = model_.geometry.total_area;
  noted.shadow_area = score.shadow_area;
  noted.uncertainty.readout = score.undercut_error;
  return noted;
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
          .undercuts = measured != nullptr && measured->undercuts ? std::optional(measured->undercuts->count)
                                                                  : std::nullopt,
          .parting = measured != nullptr ? measured->parting : std::nullopt};
}

RankedFigures DirectionRating::ranked(const Candidate& candidate, const DirectionFacts& facts,
                                      double undercut_uncertainty) const {
  const bool decided = !by_actions_ || facts.actions != nullptr;
  const Objective& objective = decided ? settings_.objective : before_actions_;
  return {.value = objective_value(objective, facts),
          .value_uncertainty = weight_of_undercut(objective) * undercut_uncertainty / measure_.area,
          .undercut = facts.classification.areas[Region::undercut],
          .undercut_uncertainty = undercut_uncertainty,
          .undercuts = static_cast<double>(facts.actions != nullptr ? facts.actions->undercuts.count
                                                                    : facts.undercuts.value_or(0)),
          .draw_depth = facts.draw_depth,
          .projected_area = facts.classification.shadow_area,
          .actions = facts.actions != nullptr ? facts.actions->weight + unreleased_penalty(facts) : 0.0,
          .travel = facts.actions != nullptr ? facts.actions->travel : 0.0,
          .decided = decided,
          .exact = candidate.exact()};
}

RankedFigures DirectionRating::scored(const Candidate& candidate, const DirectionScore& score) const {
  const Classification noted = classification(candidate.direction, score);
  // What is known of a direction given up is that it is worse: it ties with nothing.
  return ranked(candidate, facts(noted, nullptr), score.given_up ? 0.0 : score.undercut_error);
}

RankedFigures DirectionRating::measured(const Candidate& candidate, const MeasuredDirection& measured,
                                        const std::optional<DirectionActions>& actions,
                                        bool with_undercuts) const {
  DirectionFacts found = facts(measured.classification, &measured);
  if (!with_undercuts) found.undercuts.reset();
  if (actions) found.actions = &*actions;
  return ranked(candidate, found, measured.classification.uncertainty.rounding);
}

}  // namespace moldlight
