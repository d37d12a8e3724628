// What is said of the surface under the cursor.
#pragma once

#include "gui/app_state.hpp"

namespace moldlight::gui {

/// Draft, class and, for an undercut, what blocks it: found by exact rays, so that it names one facet.
[[nodiscard]] Hover describe(const PartModel& model, const MethodSettings& method, const PickedPoint& point);

}  // namespace moldlight::gui
