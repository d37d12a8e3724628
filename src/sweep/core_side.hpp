// Which half of a mold is the core.
#pragma once

#include <string>

#include "classify/part_model.hpp"
#include "classify/settings.hpp"

namespace moldlight {

struct CoreSide {
  bool along = true;      // the core is on the direction's side, else on the opposite one
  double inner = 0.0;     // area of the walls that face another wall and that the core forms alone
  double opposite = 0.0;  // the same of the cavity
  std::string why;
};

/// The part shrinks onto the half that forms more of its inner walls, stays on it when the mold opens, and is
/// ejected there. Where both form as much, the core is the half that forms more of the surface alone.
/// Throws Cancelled.
[[nodiscard]] CoreSide core_side(const PartModel& model, const Query& query, const Progress& progress);

}  // namespace moldlight
