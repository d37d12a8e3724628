#include "mold/direction_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr double k_beside_axis_deg = 10.0;
constexpr int k_decimals = 3;                    // enough for every vector that is farther off an axis
constexpr double k_least_shown_lean_deg = 1e-4;  // nobody can set a mold up by less

std::string component(double value) {
  const bool is_zero = std::abs(value) < 0.5 * std::pow(10.0, -k_decimals);
  return fmt::format("{:.{}f}", is_zero ? 0.0 : value, k_decimals);
}

}  // namespace

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
