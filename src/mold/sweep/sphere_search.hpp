// Steps on the sphere of directions.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

/// `count` unit directions at `angle_deg` from a unit direction, evenly around it; the first lies at
/// `phase_deg` from an axis that depends on the direction alone.
[[nodiscard]] std::vector<glm::dvec3> ring_around(const glm::dvec3& direction, double angle_deg, int count,
                                                  double phase_deg);

/// Angle between two unit directions in degrees, [0, 180]; exact for small angles.
[[nodiscard]] double direction_angle_deg(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace moldlight
