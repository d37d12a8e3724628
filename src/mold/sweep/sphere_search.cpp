#include "mold/sweep/sphere_search.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mold/map_frame.hpp"

namespace moldlight {

std::vector<glm::dvec3> ring_around(const glm::dvec3& direction, double angle_deg, int count,
                                    double phase_deg) {
  const MapFrame frame = map_frame(direction);
  const double angle = glm::radians(angle_deg);
  std::vector<glm::dvec3> ring;
  ring.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double turn = glm::radians(phase_deg + 360.0 * k / count);
    const glm::dvec3 aside = std::cos(turn) * frame.x + std::sin(turn) * frame.y;
    ring.push_back(glm::normalize(std::cos(angle) * frame.z + std::sin(angle) * aside));
  }
  return ring;
}

double direction_angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace moldlight
