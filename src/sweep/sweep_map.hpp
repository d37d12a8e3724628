// The directions that a sweep has scored, while it runs: as a field over all directions, and the nearest of
// one.
#pragma once

#include <vector>

#include "mold/direction_field.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

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

}  // namespace moldlight
