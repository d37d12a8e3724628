// Directions in words: what a reader takes for an axis is one.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace moldlight {

/// Less than this off an axis is rounding.
inline constexpr double k_on_axis_deg = 1e-6;

/// The axis of the file that a direction lies along or beside, with its sign.
struct NearestAxis {
  glm::dvec3 axis{0, 0, 1};
  std::string name;        // "z", "-y"
  double angle_deg = 0.0;  // [0, 55]
  [[nodiscard]] bool is_met() const { return angle_deg <= k_on_axis_deg; }
};
/// Of a unit direction; of axes alike the first of z, y, x.
[[nodiscard]] NearestAxis nearest_axis(const glm::dvec3& direction);

/// An angle in two digits, in whole degrees from 10 on: "0.22°", "4.4°", "0.00013°".
[[nodiscard]] std::string angle_text(double deg);

/// Of a unit direction: "z", "-y"; within 10 degrees of an axis "0.22° off z (towards +x)"; else its vector,
/// "0.000, 0.799, 0.602".
[[nodiscard]] std::string direction_words(const glm::dvec3& direction);

/// The side towards which `toward` leans from `direction`, by the axes that it follows most: "+x", "+x-z".
[[nodiscard]] std::string lean_text(const glm::dvec3& direction, const glm::dvec3& toward);

}  // namespace moldlight
