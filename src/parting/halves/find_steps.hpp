// Which steps meet an outline: what heights it leaves at each place along a direction, and straight lines
// through these.
#pragma once

#include <optional>
#include <vector>

#include "parting/halves/step_profile.hpp"

namespace moldlight {

/// The profile of the fewest planes that meets all of an outline, along the directions of its longest
/// straight stretches or square to them, with levels as near as may be to `wish`; parted where it has to be.
/// None where there is none of a few planes within the slope that is allowed.
[[nodiscard]] std::optional<StepProfile> find_steps(const std::vector<RimSegment>& rims, double wish,
                                                    const ShelfShape& shape);

}  // namespace moldlight
