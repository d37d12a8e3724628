// Directions, and lines along them.
#pragma once

#include <glm/vec3.hpp>

namespace moldlight {

/// The direction at length one; one that has it already comes back to the bit, so that a direction that was
/// printed in full means the same when it is read again. Throws UsageError for a zero or non-finite
/// direction.
[[nodiscard]] glm::dvec3 unit_direction(const glm::dvec3& direction);

/// The direction or its opposite, whichever has z > 0; on the equator y > 0; on the x-axis x > 0. A component
/// below 1e-9 counts as 0.
[[nodiscard]] glm::dvec3 half_sphere(const glm::dvec3& direction);

/// Angle in degrees between the lines along two unit directions, [0, 90].
[[nodiscard]] double line_angle_deg(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace moldlight
