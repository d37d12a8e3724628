// Draft angles and the three facet classes (paper, section 2.2).
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace moldlight {

/// Up: draft angle >= tau; down: <= -tau; near-vertical: between. The values are those in the shaders.
enum class FacetClass : std::uint8_t { up = 0, down = 1, near_vertical = 2 };

/// Class of a facet with unit normal `normal` for the unit parting direction `direction`; tau in degrees, [0,
/// 90).
[[nodiscard]] FacetClass facet_class(const glm::dvec3& normal, const glm::dvec3& direction, double tau_deg);

/// The same from n . d and sin tau.
[[nodiscard]] constexpr FacetClass facet_class(double sine, double sine_of_tau) {
  if (sine >= sine_of_tau) return FacetClass::up;
  return sine <= -sine_of_tau ? FacetClass::down : FacetClass::near_vertical;
}

/// Draft angle asin(n . d) in degrees, [-90, 90].
[[nodiscard]] double draft_angle_deg(const glm::dvec3& normal, const glm::dvec3& direction);

}  // namespace moldlight
