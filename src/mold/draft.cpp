#include "mold/draft.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

FacetClass facet_class(const glm::dvec3& normal, const glm::dvec3& direction, double tau_deg) {
  return facet_class(glm::dot(normal, direction), std::sin(glm::radians(tau_deg)));
}

double draft_angle_deg(const glm::dvec3& normal, const glm::dvec3& direction) {
  return glm::degrees(std::asin(std::clamp(glm::dot(normal, direction), -1.0, 1.0)));
}

}  // namespace moldlight
