// Directions, and lines along them.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace moldlight {

/// The direction at length one; one that has it already comes back to the bit, so that a direction that was
/// printed in full means the same when it is read again. Throws UsageError for a zero or non-finite
/// direction.
[[nodiscard]] glm::dvec3 unit_direction(const glm::dvec3& direction);

/// A parting direction +d, in which the core's side opens: as it was given, which a field goes on showing,
/// and at length one, which everything else asks for.
class Direction {
 public:
  Direction() = default;  // +z
  /// Of any length; throws as unit_direction() does.
  Direction(const glm::dvec3& given) : given_(given), unit_(unit_direction(given)) {}

  [[nodiscard]] const glm::dvec3& given() const { return given_; }
  [[nodiscard]] const glm::dvec3& unit() const { return unit_; }
  [[nodiscard]] bool operator==(const Direction& other) const { return given_ == other.given_; }

 private:
  glm::dvec3 given_{0.0, 0.0, 1.0}, unit_{0.0, 0.0, 1.0};
};

/// The direction or its opposite, whichever has z > 0; on the equator y > 0; on the x-axis x > 0. A component
/// below 1e-9 counts as 0.
[[nodiscard]] glm::dvec3 half_sphere(const glm::dvec3& direction);

/// Angle in degrees between the lines along two unit directions, [0, 90].
[[nodiscard]] double line_angle_deg(const glm::dvec3& a, const glm::dvec3& b);

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
