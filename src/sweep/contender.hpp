// A direction on its way through the sweep.
#pragma once

#include <memory>
#include <optional>

#include "sweep/candidates/candidate.hpp"
#include "sweep/direction_actions.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/direction_scorer.hpp"
#include "sweep/mold_rank.hpp"
#include "sweep/ranking.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

struct Contender {
  Candidate candidate;
  DirectionScore score;
  RankedFigures figures;                              // as measured, or by the score before
  std::shared_ptr<const MeasuredDirection> measured;  // none before
  std::optional<DirectionActions> actions = {};       // once they are found
  std::optional<MoldCost> cost = {};                  // by rank as molds go, with its actions
  std::optional<BesideDirection> beside = {};

  [[nodiscard]] bool canonical() const { return candidate.canonical.has_value(); }
};

/// What is handed over of a scored direction.
[[nodiscard]] inline EvaluatedDirection evaluated_direction(const glm::dvec3& direction, CandidateKind kind,
                                                            const DirectionScore& score) {
  return {.direction = direction,
          .kind = kind,
          .undercut = score.undercut(),
          .undercut_error = score.undercut_error,
          .given_up = score.given_up};
}

}  // namespace moldlight
