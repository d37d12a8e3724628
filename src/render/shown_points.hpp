// What a picture of a part, or of an opened mold, has to have room for.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

/// What a picture of the part is to show: its outermost points, in halves that have opened so far along the
/// direction (unit), and their arrows.
[[nodiscard]] std::vector<glm::vec3> points_to_show(std::span<const glm::vec3> extremes,
                                                    const glm::dvec3& direction, double open_mold);
}  // namespace moldlight
