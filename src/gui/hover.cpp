#include "gui/hover.hpp"

#include <glm/geometric.hpp>

#include "mold/exact_rays.hpp"
#include "session/classifier.hpp"

namespace moldlight::gui {

Hover describe(const PartModel& model, const MethodSettings& method, const PickedPoint& point) {
  const glm::dvec3& normal = model.geometry.normals[point.facet];
  const glm::dvec3 direction = glm::normalize(method.direction);
  Hover hover{.point = point,
              .draft_deg = draft_angle_deg(normal, direction),
              .facet_class = facet_class(normal, direction, method.tau_deg),
              .blocker = {}};
  if (point.region != Region::undercut) return hover;
  const double lateral = map_settings(method, model.frame.diagonal).lateral;
  const glm::vec3 origin =
      hover.facet_class == FacetClass::near_vertical
          ? lateral_point(point.position, normal, {.direction = direction, .lateral = lateral})
          : point.position;
  for (const bool above : {true, false}) {
    if (hover.facet_class == (above ? FacetClass::down : FacetClass::up)) continue;
    const auto hit = model.rays().first_hit(origin, glm::vec3(above ? direction : -direction), true);
    if (!hit) continue;
    const Blocker blocker{hit->facet, hit->distance * model.frame.diagonal, above};
    if (!hover.blocker || blocker.distance < hover.blocker->distance) hover.blocker = blocker;
  }
  return hover;
}

}  // namespace moldlight::gui
