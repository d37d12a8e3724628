#include "parting/mold_frame.hpp"

#include <cmath>

#include <glm/common.hpp>

namespace moldlight {

int axis_of(const glm::dvec3& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) == 1.0) return axis;
  }
  return -1;
}

MoldFrame mold_frame(const glm::dvec3& direction) {
  MoldFrame frame;
  frame.z = direction;
  const int axis = axis_of(direction);
  if (axis >= 0) {
    frame.x = frame.y = glm::dvec3(0.0);
    frame.x[(axis + 1) % 3] = 1.0;
    frame.y[(axis + 2) % 3] = direction[axis];
    return frame;
  }
  const glm::dvec3 size = glm::abs(direction);
  glm::dvec3 least(0.0);
  least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
  frame.x = glm::normalize(glm::cross(least, direction));
  frame.y = glm::cross(direction, frame.x);
  return frame;
}

}  // namespace moldlight
