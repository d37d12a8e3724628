// What the window knows of a sweep: what the user has chosen, how far it is, what it found.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mold/direction_field.hpp"
#include "sweep/direction_cards.hpp"

namespace moldlight::gui {

/// What the user sets about the sweep; panels edit a copy of it.
struct SweepChoices {
  SweepSettings options;                // the method is the window's when the sweep starts
  std::optional<std::size_t> compared;  // candidate of the result that is seen beside the direction
  bool large_ball = false;
};

struct SweepProgress {
  std::string stage;
  double share = 0.0;  // of the whole sweep, [0, 1]
  std::optional<double> left_s;
  bool ending = false;  // cancelled; what is done is being gathered
};

/// Every direction scored so far. Grows while the sweep runs.
struct SweepMap {
  explicit SweepMap(double reach_deg) : field(reach_deg) {}

  std::vector<EvaluatedDirection> evaluated;
  DirectionField field;
  double worst = 0.0;  // greatest undercut area

  void add(const EvaluatedDirection& direction);
  /// The evaluated direction, or opposite of one, that is nearest; none within `reach_deg`: null.
  [[nodiscard]] const EvaluatedDirection* nearest(const glm::dvec3& direction, double reach_deg) const;
};

struct SweepState {
  std::optional<SweepProgress> running;
  std::optional<SweepMap> map;
  /// Of the last sweep that ended; of one that runs by itself what it knew before its search.
  std::shared_ptr<const SweepResult> result;
  std::vector<DirectionCard> cards;  // of the result, beside the direction at rest
  bool stale = false;                // the method, or what is allowed of side actions, has changed since
  bool by_itself = false;            // nobody asked for it
  std::string error;                 // why there is no result
};

}  // namespace moldlight::gui
