// The rating of a direction: its figures and the objective made of them.
#pragma once

#include <span>
#include <vector>

#include "classify/part_model.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/direction_scorer.hpp"
#include "sweep/ranking.hpp"

namespace moldlight {

/// Where the objective needs side actions, the undercut stands in for them until they are found: what is
/// hidden from both sides asks for side actions, if not in proportion.
class DirectionRating {
 public:
  /// Both must outlive the rating.
  DirectionRating(const PartModel& model, const SweepSettings& settings);

  /// Figures by a score; undercuts are not known yet and count as none.
  [[nodiscard]] RankedFigures scored(const Candidate& candidate, const DirectionScore& score) const;
  /// Figures as measured, with side actions where they are known; for comparing them with scored ones without
  /// the undercuts. What a faulty mesh leaves in doubt makes no ties: it is about the same for all.
  [[nodiscard]] RankedFigures measured(const Candidate& candidate, const MeasuredDirection& measured,
                                       const std::optional<DirectionActions>& actions = {},
                                       bool with_undercuts = true) const;

  [[nodiscard]] Ranking rank(std::span<const RankedFigures> figures) const {
    return rank_directions(figures, measure_);
  }
  /// The objective's worth of an undercut area.
  [[nodiscard]] double value_of_undercut(double area) const {
    return undercut_weight_ * area / measure_.area;
  }
  /// As far as it is known before side actions are.
  [[nodiscard]] bool by_undercut_alone() const { return by_undercut_alone_; }
  /// What the objective asks for beside regions and side actions.
  [[nodiscard]] const MeasuredBeside& beside() const { return beside_; }
  [[nodiscard]] bool by_actions() const { return by_actions_; }

  /// What a score knows of what classify would give.
  [[nodiscard]] Classification classification(const glm::dvec3& direction, const DirectionScore& score) const;
  /// `measured`: null where the classification is what a score knows. The facts refer to the classification.
  [[nodiscard]] DirectionFacts facts(const Classification& classification,
                                     const MeasuredDirection* measured) const;

 private:
  [[nodiscard]] RankedFigures ranked(const Candidate& candidate, const DirectionFacts& facts,
                                     double undercut_uncertainty) const;

  const PartModel& model_;
  const SweepSettings& settings_;
  std::vector<glm::dvec3> corners_;  // of the facets, each once, from the frame's centre
  PartMeasure measure_;
  Objective before_actions_;
  double undercut_weight_ = 0.0;  // of the objective before side actions are known
  bool by_undercut_alone_ = true, by_actions_ = false;
  MeasuredBeside beside_;
};

}  // namespace moldlight
