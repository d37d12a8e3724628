#include "render/parting_arrow.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {
constexpr double k_gap = 0.035, k_length = 0.13, k_head_length = 0.048, k_head_radius = 0.0145,
                 k_shaft_radius = 0.0045;
}

PartingArrow parting_arrow(std::span<const glm::vec3> extremes, const glm::dvec3& toward, double opened) {
  double top = 0.0;
  for (const glm::vec3& point : extremes) top = std::max(top, glm::dot(glm::dvec3(point), toward));
  const double reach = top + opened + k_gap;
  return {.tail = reach * toward,
          .tip = (reach + k_length) * toward,
          .shaft_radius = k_shaft_radius,
          .head_radius = k_head_radius,
          .head_length = k_head_length};
}

}  // namespace moldlight
