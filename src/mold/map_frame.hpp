// The frames about parting directions.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mold/direction.hpp"

namespace moldlight {

/// Right-handed orthonormal axes; z is the parting direction.
struct MapFrame {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

/// Frame for a direction of any length but zero. The axes x and y are twisted about z by a fixed odd angle,
/// so that walls along the coordinate axes do not fall on whole rows of texels at once: the error of one wall
/// is then not that of all. Throws UsageError for a zero or non-finite direction.
[[nodiscard]] MapFrame map_frame(const glm::dvec3& direction);

/// `count` unit directions at `angle_deg` from a unit direction, evenly around it; the first lies at
/// `phase_deg` from an axis that depends on the direction alone.
[[nodiscard]] std::vector<glm::dvec3> ring_around(const glm::dvec3& direction, double angle_deg, int count,
                                                  double phase_deg);

}  // namespace moldlight
