// Cost of a parting line along each edge.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace moldlight {

/// Of a straight piece: its length, and three times as much for what of it climbs along the unit direction.
[[nodiscard]] inline double line_cost(const glm::dvec3& piece, const glm::dvec3& direction) {
  constexpr double k_climb_weight = 3.0;
  return glm::length(piece) + k_climb_weight * std::abs(glm::dot(piece, direction));
}

}  // namespace moldlight
