// Colours of undercut areas on maps of the directions: from a pale one for none to a dark one for the worst,
// with steadily falling lightness, so that every eye and a gray print read it.
#pragma once

#include "mold/region.hpp"

namespace moldlight {

/// Place of an area on the scale, [0, 1]: the square root of its share of `worst`, which spreads the small
/// areas that matter.
[[nodiscard]] double undercut_scale(double area, double worst);
/// `place` in [0, 1].
[[nodiscard]] Colour undercut_scale_colour(double place);

}  // namespace moldlight
