// Slides that would meet each other on their ways.
#pragma once

#include <utility>
#include <vector>

#include "actions/side_action.hpp"

namespace moldlight {

/// Fills in `meets` of each slide, inclined ones among them: the others whose way it crosses. The way of a
/// slide is what its surface sweeps out to beyond the part, and its travel on. Two slides whose ways cross
/// stand in each other's way whichever goes first, as long as each reaches outward along its own direction.
void find_meetings(const PartModel& model, const SplitMesh& split, const Release& release, ActionPlan& plan);

/// A slide of a plan that moves otherwise: along `direction` (unit), by `travel` in the part's unit.
struct SlideMove {
  glm::dvec3 direction{1, 0, 0};
  double travel = 0.0;
};
/// What two slides of a plan form, moved in each of these ways: pairs of ways, of one and of the other, that
/// cross.
struct MovedSlide {
  std::size_t action = 0;  // of the plan
  std::vector<SlideMove> moves = {};
};
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> crossing_moves(
    const PartModel& model, const SplitMesh& split, const Release& release, const ActionPlan& plan,
    const MovedSlide& one, const MovedSlide& other);

}  // namespace moldlight
