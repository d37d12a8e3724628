#include "mold/accessibility.hpp"

#include <glm/geometric.hpp>

namespace moldlight {

glm::vec3 lateral_point(const glm::vec3& point, const glm::dvec3& normal, const AccessibilityQuery& query) {
  const glm::dvec3 level = normal - glm::dot(normal, query.direction) * query.direction;
  return glm::vec3(glm::dvec3(point) + query.lateral * glm::normalize(level));
}

Accessibility exact_accessibility(const ExactRays& rays, const glm::vec3& point, const glm::dvec3& normal,
                                  FacetClass facet_class, const AccessibilityQuery& query) {
  const glm::vec3 up(query.direction);
  switch (facet_class) {
    case FacetClass::up:
      return {.plus = !rays.surface_point_blocked(point, glm::vec3(normal), up), .minus = false};
    case FacetClass::down:
      return {.plus = false, .minus = !rays.surface_point_blocked(point, glm::vec3(normal), -up)};
    case FacetClass::near_vertical:
      break;
  }
  const glm::vec3 beside = lateral_point(point, normal, query);
  return {.plus = !rays.blocked(beside, up), .minus = !rays.blocked(beside, -up)};
}

}  // namespace moldlight
