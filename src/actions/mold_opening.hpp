// In which order a mold opens, and how far each of its parts has moved.
#pragma once

#include <string>

#include "actions/side_action.hpp"

namespace moldlight {

/// Whether it moves before the halves; lifters and inserts come with the part.
[[nodiscard]] bool goes_first(const SideAction& action);

/// "1 slide moves out first.", "2 slides and 1 unscrewing core move out first."
[[nodiscard]] std::string first_moves_text(const ActionPlan& plan);

/// The greatest travels of what moves before the halves, and after them.
struct OpeningWays {
  double first = 0.0, last = 0.0;
};
[[nodiscard]] OpeningWays ways_of(const ActionPlan* plan);

/// How far each has moved, [0, 1].
struct OpenedMold {
  double slides = 0.0;   // and unscrewing cores
  double halves = 0.0;   // of k_mold_travel
  double lifters = 0.0;  // with the ejection
};
/// What moves first, slides and unscrewing cores, the halves, or lifters, by how far the mold is opened, [0,
/// 1]; halves alone where there is no plan. Each of them that moves has an equal share.
[[nodiscard]] OpenedMold opened_mold(const ActionPlan* plan, double open);
/// Where on that way what moves first has moved; 0 where nothing does.
[[nodiscard]] double slides_end(const ActionPlan* plan);

}  // namespace moldlight
