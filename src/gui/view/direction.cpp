#include "gui/view/direction.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "mold/direction.hpp"

namespace moldlight::gui {

Angles angles_of(const glm::dvec3& direction) {
  const double elevation = glm::degrees(std::asin(std::clamp(direction.z, -1.0, 1.0)));
  const bool pole = std::hypot(direction.x, direction.y) < 1e-9;
  return {pole ? 0.0 : glm::degrees(std::atan2(direction.y, direction.x)), elevation};
}

glm::dvec3 direction_of(const Angles& angles) {
  const double azimuth = glm::radians(angles.azimuth_deg), elevation = glm::radians(angles.elevation_deg);
  return tidy({std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
               std::sin(elevation)});
}

glm::dvec3 nudged(const glm::dvec3& direction, const glm::dvec3& toward, const glm::dvec3& aside,
                  double angle_deg) {
  glm::dvec3 side = toward - glm::dot(toward, direction) * direction;
  if (glm::length(side) < 1e-6) side = aside - glm::dot(aside, direction) * direction;
  const double angle = glm::radians(angle_deg);
  return tidy(std::cos(angle) * direction + std::sin(angle) * glm::normalize(side));
}

glm::dvec3 tidy(const glm::dvec3& direction) {
  glm::dvec3 unit = unit_direction(direction);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double round : {-1.0, 0.0, 1.0})
      if (std::abs(unit[axis] - round) < 1e-12) unit[axis] = round;
  }
  return unit;
}

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
