// Slides, and lifters, that would meet each other on their ways.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "actions/side_action.hpp"

namespace moldlight {

/// An action of a plan that moves otherwise: along `direction` (unit), by `travel` and, of a lifter, the
/// `room` beyond it in the part's unit.
struct ActionMove {
  glm::dvec3 direction{1, 0, 0};
  double travel = 0.0;
  double room = 0.0;
  bool core_side = true;
};
/// A lifter is as thick as it needs to be, or as it has room for.
[[nodiscard]] ActionMove move_of(const SideAction& action);
/// What an action of a plan forms, moved in each of these ways.
struct MovedAction {
  std::size_t action = 0;  // of the plan
  std::vector<ActionMove> moves = {};
};

/// Of the plans of one part along one direction. What several plans have in common is asked once.
class MeetingFinder {
 public:
  /// All must outlive it.
  MeetingFinder(const PartModel& model, const SplitMesh& split, const Release& release);
  ~MeetingFinder();

  /// Fills in `meets` of each slide, inclined ones among them, and of each lifter: the others of its kind
  /// whose way it crosses. The way of a slide is what its surface sweeps out to beyond the part, and its
  /// travel on. Two slides whose ways cross stand in each other's way whichever goes first, as long as each
  /// reaches outward along its own direction. The way of a lifter ends its travel and its own thickness
  /// beyond what it forms; lifters of one half move together. A slide also meets every action, of any kind
  /// but what is stripped, through whose undercut it goes on its way out.
  void find(ActionPlan& plan);
  /// Pairs of moves, of one action and of the other, whose ways cross.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> crossing_moves(const ActionPlan& plan,
                                                                                const MovedAction& one,
                                                                                const MovedAction& other);

 private:
  struct Known;
  const PartModel& model_;
  const SplitMesh& split_;
  const Release& release_;
  std::unique_ptr<Known> known_;
};

}  // namespace moldlight
