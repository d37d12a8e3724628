// Maps for pictures of a direction that moves: coarser, so that they keep up with the hand.
#pragma once

#include "session/settings.hpp"

namespace moldlight {

/// The settings with maps of 1024 texels at most. Lateral tolerance and edge thickness stay the lengths that
/// they are for the settings' own maps. `diagonal` of the part, model units.
[[nodiscard]] MethodSettings live_method(const MethodSettings& settings, double diagonal);

}  // namespace moldlight
