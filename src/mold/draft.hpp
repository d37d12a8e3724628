// Draft angles and the three facet classes (paper, section 2.2).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace moldlight {

/// Up: draft angle >= tau; down: <= -tau; near-vertical: between. The values are those in the shaders.
enum class FacetClass : std::uint8_t { up = 0, down = 1, near_vertical = 2 };

/// Class of a facet from n . d and sin tau.
[[nodiscard]] constexpr FacetClass facet_class(double sine, double sine_of_tau) {
  if (sine >= sine_of_tau) return FacetClass::up;
  return sine <= -sine_of_tau ? FacetClass::down : FacetClass::near_vertical;
}

/// The same for a unit normal and the unit parting direction; tau in degrees, [0, 90).
[[nodiscard]] inline FacetClass facet_class(const glm::dvec3& normal, const glm::dvec3& direction,
                                            double tau_deg) {
  return facet_class(glm::dot(normal, direction), std::sin(glm::radians(tau_deg)));
}

/// Draft angle asin(n . d) in degrees, [-90, 90].
[[nodiscard]] inline double draft_angle_deg(const glm::dvec3& normal, const glm::dvec3& direction) {
  return glm::degrees(std::asin(std::clamp(glm::dot(normal, direction), -1.0, 1.0)));
}

}  // namespace moldlight
