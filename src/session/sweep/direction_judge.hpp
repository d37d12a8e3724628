// What a direction of a part is worth: its figures and the objective made of them.
#pragma once

#include <span>
#include <vector>

#include "mold/sweep/direction_scorer.hpp"
#include "mold/sweep/ranking.hpp"
#include "session/part_model.hpp"
#include "session/sweep/direction_measurer.hpp"
#include "session/sweep/sweep_result.hpp"

namespace moldlight {

class DirectionJudge {
 public:
  /// `model` must outlive the judge. Throws UsageError for an objective that makes no sense.
  DirectionJudge(const PartModel& model, const SweepSettings& settings);

  /// Figures by a score; patches are not known yet and count as none.
  [[nodiscard]] DirectionFigures scored(const Candidate& candidate, const DirectionScore& score) const;
  /// Figures as measured. What a faulty mesh leaves in doubt makes no ties: it is about the same for all.
  [[nodiscard]] DirectionFigures measured(const Candidate& candidate,
                                          const MeasuredDirection& measured) const;

  [[nodiscard]] double value(const DirectionFigures& figures) const {
    return objective_value(objective_, figures, measure_);
  }
  [[nodiscard]] Ranking rank(std::span<const DirectionFigures> figures) const {
    return rank_directions(figures, objective_, measure_);
  }
  /// The objective's worth of an undercut area.
  [[nodiscard]] double value_of_undercut(double area) const;
  [[nodiscard]] bool by_undercut_alone() const;
  [[nodiscard]] double near_vertical_area(const glm::dvec3& direction) const;

 private:
  [[nodiscard]] double draw_depth(const glm::dvec3& direction) const;

  const PartModel& model_;
  std::vector<glm::dvec3> corners_;  // of the facets, each once, from the frame's centre
  double tau_deg_;
  Objective objective_;
  PartMeasure measure_;
};

}  // namespace moldlight
