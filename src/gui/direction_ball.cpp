#include "gui/direction_ball.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "gui/direction.hpp"

namespace moldlight::gui {

BallPoint ball_point(const Camera& camera, const glm::dvec3& direction) {
  const glm::dvec3 seen = glm::conjugate(camera.orientation) * direction;
  return {{seen.x, seen.y}, seen.z >= 0.0};
}

glm::dvec3 ball_direction(const Camera& camera, const BallPoint& point) {
  const double radius = glm::length(point.at);
  glm::dvec3 seen(0, 0, 1);
  if (radius <= 1.0) {
    seen = glm::dvec3(point.at, std::sqrt(std::max(0.0, 1.0 - radius * radius)));
  } else {
    const double angle = 0.5 * glm::pi<double>() * std::min(radius, 2.0);
    seen = glm::dvec3(point.at / radius * std::sin(angle), std::cos(angle));
  }
  if (!point.front) seen.z = -seen.z;
  return tidy(camera.orientation * seen);
}

}  // namespace moldlight::gui
