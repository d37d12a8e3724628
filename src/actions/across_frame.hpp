// Directions beside others that turn with the part and are mirrored with it.
#pragma once

#include <glm/vec3.hpp>

#include "actions/part_axes.hpp"

namespace moldlight {

/// Two directions across another one (all unit), at an odd angle to the axes, so that walls do not lie along
/// them.
struct AcrossFrame {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0};
};
[[nodiscard]] AcrossFrame across_frame(const PartAxes& axes, const glm::dvec3& direction);

/// Which way along a direction the surface reaches farther from its centre, by its third moments: 1 or -1; 0
/// where it reaches as far either way.
[[nodiscard]] int longer_along(const PartModel& model, const glm::dvec3& direction);

}  // namespace moldlight
