// Figures of the bodies that actions move: how large they are, and whether they are clear of the part
// and of each other as the mold moves.
#pragma once

#include "actions/side_action.hpp"
#include "base/progress.hpp"

namespace moldlight {

/// How finely bodies are played.
struct BodyPlay {
  std::size_t points = 300;  // of a body's surface, at least 1
  int steps = 40;            // of its travel, and of its way out, at least 1
};

/// Fills in `body` of every action that has a body. `result` is a classification that has its split mesh,
/// from which `plan` was found. Throws Cancelled.
void measure_bodies(const PartModel& model, const Classification& result, const Progress& progress,
                    ActionPlan& plan, const BodyPlay& play = {});

}  // namespace moldlight
