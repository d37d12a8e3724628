// Ranking of parting directions: ties and the Pareto front.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace moldlight {

/// What a direction is ranked by: areas in model units squared, draw depth in model units; less is better.
struct RankedFigures {
  double value = 0.0;              // of the objective
  double value_uncertainty = 0.0;  // from the undercut's
  double undercut = 0.0, undercut_uncertainty = 0.0;
  double undercuts = 0.0, draw_depth = 0.0, projected_area = 0.0;
  double actions = 0.0, travel = 0.0;  // of side actions, where they decide ties: weight, model units
  bool decided = true;                 // the objective is known; where it is not, the value stands in for it
  bool exact = false;  // a direction given by the user or by a feature of the part, not by search
};

/// Sizes of the part beside which rounding is known.
struct PartMeasure {
  double area = 1.0;      // model units squared
  double diagonal = 1.0;  // model units
};

struct Ranking {
  std::vector<std::size_t> order;      // best first, indices into the figures
  std::vector<std::size_t> tie_group;  // by index: 0 for the best and all that tie with it, then 1, …
  std::vector<bool> pareto;  // by index: no other is at least as good in undercut area, undercuts and draw
                             // depth and better in one; undercut areas that differ by less than their
                             // uncertainties are equal
};

/// What is decided comes before what is not. Directions tie when their objectives differ by no more than
/// their undercut uncertainties make them. A tie group is a best direction and all that tie with it. Within a
/// group side actions of less weight come first, then those of less travel, to a hundredth of the diagonal,
/// then exact directions, then the smaller draw depth, then the smaller projected area, then the order given.
[[nodiscard]] Ranking rank_directions(std::span<const RankedFigures> figures, const PartMeasure& part);

}  // namespace moldlight
