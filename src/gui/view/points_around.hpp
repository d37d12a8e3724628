// What a picture of a place is to show.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace moldlight::gui {

/// Six points at this distance from the centre, along the axes.
[[nodiscard]] inline std::vector<glm::vec3> points_around(const glm::vec3& centre, double reach) {
  std::vector<glm::vec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-reach, reach}) {
      points.push_back(centre);
      points.back()[axis] += static_cast<float>(side);
    }
  }
  return points;
}

}  // namespace moldlight::gui
