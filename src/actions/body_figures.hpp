// The solids that the actions of a plan move, how large they are, and whether they stay clear of the part
// and of each other as the mold moves.
#pragma once

#include <map>
#include <vector>

#include "actions/side_action.hpp"
#include "base/progress.hpp"

namespace moldlight {

/// How finely bodies are played.
struct BodyPlay {
  std::size_t points = 1500;  // of a body's surface, about
  int steps = 40;             // of its travel, and of its way out, at least 1
};

/// Of the plans of one part along one direction. What several plans have in common is shaped and played once.
class BodyPlayer {
 public:
  /// Of a classification that has its split mesh, from which the plans are found. All of it must outlive it.
  BodyPlayer(const PartModel& model, const Classification& result, const Progress& progress,
             const BodyPlay& play = {});
  ~BodyPlayer();

  /// Fills in `body` of every action that has a body, of a plan with its undercuts; by a tenth of the points
  /// unless it is to be `fine`. Throws Cancelled.
  void measure(ActionPlan& plan, bool fine = true);

 private:
  struct Shape;
  const PartModel& model_;
  const SplitMesh& split_;
  ExactQuery query_;
  const Progress& progress_;
  BodyPlay play_;
  std::map<std::vector<double>, Shape> known_;  // by what an action forms and how it moves
};

}  // namespace moldlight
