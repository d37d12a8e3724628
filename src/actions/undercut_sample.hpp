// A sample of undercut surface.
#pragma once

#include <glm/vec3.hpp>

namespace moldlight {

/// A point of an undercut, and the surface there.
struct UndercutSample {
  glm::vec3 position{0.0F};  // unit frame
  glm::dvec3 normal{0.0};    // unit, outward
  double area = 0.0;         // that it stands for, the part's unit squared
};

}  // namespace moldlight
