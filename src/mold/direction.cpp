#include "mold/direction.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.hpp"

namespace moldlight {

namespace {

/// Of the squared length of a unit vector, after rounding.
constexpr double k_unit_rounding = 4e-15;
constexpr double k_on_equator = 1e-9;

}  // namespace

glm::dvec3 unit_direction(const glm::dvec3& direction) {
  if (std::abs(glm::dot(direction, direction) - 1.0) <= k_unit_rounding) return direction;
  const double longest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  if (!std::isfinite(longest) || longest <= 0.0) {
    throw UsageError("the parting direction must be three finite numbers, not all zero");
  }
  return glm::normalize(direction / longest);
}

glm::dvec3 half_sphere(const glm::dvec3& direction) {
  for (const int axis : {2, 1, 0}) {
    if (std::abs(direction[axis]) > k_on_equator)
      return (direction[axis] < 0.0 ? -direction : direction) + 0.0;  // no -0.0
  }
  return direction;
}

double line_angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  // By the sine: the cosine loses half the digits of a small angle.
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b))));
}

}  // namespace moldlight
