#include "mold/direction.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.hpp"

namespace moldlight {

namespace {

/// Of the squared length of a unit vector, after rounding.
constexpr double k_unit_rounding = 4e-15;
constexpr double k_on_equator = 1e-9;

constexpr double k_beside_axis_deg = 10.0;
constexpr int k_decimals = 3;                    // enough for every vector that is farther off an axis
constexpr double k_least_shown_lean_deg = 1e-4;  // nobody can set a mold up by less

std::string component(double value) {
  const bool is_zero = std::abs(value) < 0.5 * std::pow(10.0, -k_decimals);
  return fmt::format("{:.{}f}", is_zero ? 0.0 : value, k_decimals);
}

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

NearestAxis nearest_axis(const glm::dvec3& direction) {
  constexpr double k_alike = 1e-12;
  int along = 2;
  for (const int axis : {1, 0}) {
    if (std::abs(direction[axis]) > std::abs(direction[along]) + k_alike) along = axis;
  }
  NearestAxis nearest;
  const double sign = direction[along] < 0.0 ? -1.0 : 1.0;
  nearest.axis = glm::dvec3(0.0);
  nearest.axis[along] = sign;
  nearest.name = fmt::format("{}{}", sign < 0.0 ? "-" : "", "xyz"[along]);
  // By the sine: the cosine loses half the digits of a small angle.
  nearest.angle_deg = glm::degrees(
      std::atan2(glm::length(glm::cross(nearest.axis, direction)), glm::dot(nearest.axis, direction)));
  return nearest;
}

std::string angle_text(double deg) {
  const int digits = deg > 0.0 ? 1 - static_cast<int>(std::floor(std::log10(deg))) : 0;
  return fmt::format("{:.{}f}°", deg, std::max(0, digits));
}

std::string direction_words(const glm::dvec3& direction) {
  const NearestAxis nearest = nearest_axis(direction);
  if (nearest.is_met() || nearest.angle_deg < k_least_shown_lean_deg) return nearest.name;
  if (nearest.angle_deg <= k_beside_axis_deg)
    return fmt::format("{} off {} (towards {})", angle_text(nearest.angle_deg), nearest.name,
                       lean_text(nearest.axis, direction));
  return fmt::format("{}, {}, {}", component(direction.x), component(direction.y), component(direction.z));
}

std::string lean_text(const glm::dvec3& direction, const glm::dvec3& toward) {
  constexpr double k_tan_22_5_deg =
      0.41421356;  // an axis counts when the lean is not nearer to another alone
  const glm::dvec3 aside = toward - glm::dot(toward, direction) * direction;
  const double most = std::max({std::abs(aside.x), std::abs(aside.y), std::abs(aside.z)});
  if (!(most > 0.0)) return "";
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(aside[axis]) < k_tan_22_5_deg * most) continue;
    text += aside[axis] < 0.0 ? '-' : '+';
    text += "xyz"[axis];
  }
  return text;
}

}  // namespace moldlight
