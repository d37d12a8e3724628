// Accessibility of a surface point by exact rays: the definition that the maps approximate.
#pragma once

#include <glm/vec3.hpp>

#include "mold/draft.hpp"
#include "mold/exact_rays.hpp"

namespace moldlight {

struct Accessibility {
  bool plus = false;   // along +d
  bool minus = false;  // along -d
};

/// What a query needs of the parting direction. Unit frame.
struct AccessibilityQuery {
  glm::dvec3 direction{0, 0, 1};  // unit
  double lateral = 0.0;           // lateral tolerance
};

/// The point from which a near-vertical facet's accessibility is tested: `point` moved by the lateral
/// tolerance along the part of `normal` that is perpendicular to the direction.
[[nodiscard]] glm::vec3 lateral_point(const glm::vec3& point, const glm::dvec3& normal,
                                      const AccessibilityQuery& query);

/// Up and down facets are tested along the side that they face, near-vertical ones along both from
/// lateral_point().
[[nodiscard]] Accessibility exact_accessibility(const ExactRays& rays, const glm::vec3& point,
                                                const glm::dvec3& normal, FacetClass facet_class,
                                                const AccessibilityQuery& query);

}  // namespace moldlight
