#include "session/sweep/direction_judge.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "mold/draft.hpp"

namespace moldlight {

namespace {

bool is_exact(const Candidate& candidate) { return candidate.sources.front().kind < CandidateKind::refined; }

}  // namespace

DirectionJudge::DirectionJudge(const PartModel& model, const SweepSettings& settings)
    : model_(model),
      tau_deg_(settings.method.tau_deg),
      objective_(parse_objective(settings.objective)),
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
}

double DirectionJudge::value_of_undercut(double area) const {
  return objective_.weights[static_cast<std::size_t>(Criterion::undercut)] * area / measure_.area;
}

bool DirectionJudge::by_undercut_alone() const {
  return std::all_of(objective_.weights.begin() + 1, objective_.weights.end(),
                     [](double weight) { return weight == 0.0; });
}

double DirectionJudge::draw_depth(const glm::dvec3& direction) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const glm::dvec3& corner : corners_) {
    const double height = glm::dot(corner, direction);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return high >= low ? high - low : 0.0;
}

double DirectionJudge::near_vertical_area(const glm::dvec3& direction) const {
  double area = 0.0;
  for (std::size_t facet = 0; facet < model_.geometry.areas.size(); ++facet) {
    if (facet_class(model_.geometry.normals[facet], direction, tau_deg_) == FacetClass::near_vertical) {
      area += model_.geometry.areas[facet];
    }
  }
  return area;
}

DirectionFigures DirectionJudge::scored(const Candidate& candidate, const DirectionScore& score) const {
  DirectionFigures figures;
  figures[Criterion::undercut] = score.undercut();
  figures[Criterion::draw_depth] = draw_depth(candidate.direction);
  figures[Criterion::projected_area] = score.shadow_area;
  if (objective_.weights[static_cast<std::size_t>(Criterion::undraughted_area)] > 0.0) {
    figures[Criterion::undraughted_area] = near_vertical_area(candidate.direction);
  }
  // What is known of a direction given up is that it is worse: it ties with nothing.
  figures.undercut_uncertainty = score.given_up ? 0.0 : score.undercut_error;
  figures.exact = is_exact(candidate);
  return figures;
}

DirectionFigures DirectionJudge::measured(const Candidate& candidate,
                                          const MeasuredDirection& measured) const {
  const Classification& classification = measured.classification;
  DirectionFigures figures;
  figures[Criterion::undercut] = classification.areas[Region::undercut];
  figures[Criterion::patches] = static_cast<double>(measured.patches);
  figures[Criterion::draw_depth] = draw_depth(classification.direction);
  figures[Criterion::projected_area] = classification.shadow_area;
  figures[Criterion::undraughted_area] = classification.near_vertical_area;
  figures.undercut_uncertainty = classification.uncertainty.rounding;
  figures.exact = is_exact(candidate);
  return figures;
}

}  // namespace moldlight
