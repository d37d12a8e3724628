// What is said of the bodies that actions move: how large they are, and whether they are clear of the part
// and of each other as the mold moves.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "actions/side_action.hpp"
#include "base/progress.hpp"

namespace moldlight {

/// How finely bodies are played.
struct BodyPlay {
  std::size_t points = 3000;  // of a body's surface, at least 1
  int steps = 40;             // of its travel, and of its way out, at least 1
  double stem = 0.0;          // side of the square that carries a lifter, the part's unit; 0: none
};

/// Of the plans of one part and one direction; what several of them share is shaped once.
class BodyPlayer {
 public:
  BodyPlayer(const PartModel& model, const SplitMesh& split, const ExactQuery& query,
             const Progress& progress, const BodyPlay& play = {});
  ~BodyPlayer();

  /// Fills in `body` of every action of a plan that has one; the plan has its patches. Bodies that need not
  /// leave sideways are as thick as the part and those that move before them allow. Throws Cancelled.
  void measure(ActionPlan& plan);
  /// Whether a body of the plan measured last hits by more than slivers: by a fiftieth of its points, or
  /// deeper than ten lateral tolerances.
  [[nodiscard]] bool is_grave(std::size_t action) const { return grave_[action] != 0; }

  struct Solid;  // of a body

 private:
  struct Shapes;
  const PartModel& model_;
  const SplitMesh& split_;
  ExactQuery query_;
  const Progress& progress_;
  BodyPlay play_;
  std::map<std::vector<double>, Shapes> known_;  // by what an action forms and how it moves
  std::vector<std::unique_ptr<Solid>> apart_;    // cut so that they are clear of others
  std::vector<char> grave_;                      // by action
};

}  // namespace moldlight
