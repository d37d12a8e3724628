#include "mold/map_frame.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {
constexpr double k_twist_rad = 0.3217;
}  // namespace

MapFrame map_frame(const glm::dvec3& direction) {
  MapFrame frame;
  frame.z = unit_direction(direction);
  const glm::dvec3 magnitude = glm::abs(frame.z);
  glm::dvec3 least(0.0);
  least[magnitude.x <= magnitude.y && magnitude.x <= magnitude.z ? 0
        : magnitude.y <= magnitude.z                             ? 1
                                                                 : 2] = 1.0;
  const glm::dvec3 x = glm::normalize(glm::cross(least, frame.z));
  const glm::dvec3 y = glm::cross(frame.z, x);
  frame.x = std::cos(k_twist_rad) * x + std::sin(k_twist_rad) * y;
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

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

}  // namespace moldlight
