#include "gui/view/surface.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "classify/classifier.hpp"
#include "mold/exact_rays.hpp"
#include "mold/map_frame.hpp"

namespace moldlight::gui {

Hover describe(const PartModel& model, const Query& query, const PickedPoint& point) {
  const glm::dvec3& normal = model.geometry.normals[point.facet];
  const glm::dvec3& direction = query.direction.unit();
  Hover hover{.point = point,
              .draft_deg = draft_angle_deg(normal, direction),
              .facet_class = facet_class(normal, direction, query.method.tau_deg),
              .blocker = {}};
  if (point.region != Region::undercut) return hover;
  const double lateral = map_settings(query.method, model.frame.diagonal).lateral;
  const glm::vec3 origin =
      hover.facet_class == FacetClass::near_vertical
          ? lateral_point(point.position, normal, {.direction = direction, .lateral = lateral})
          : point.position;
  for (const bool above : {true, false}) {
    if (hover.facet_class == (above ? FacetClass::down : FacetClass::up)) continue;
    const glm::vec3 way(above ? direction : -direction);
    const auto hit = model.rays().first_hit(origin, way, true);
    if (!hit) continue;
    const Blocker blocker{hit->facet, hit->distance * model.frame.diagonal, above, origin,
                          origin + hit->distance * way};
    if (!hover.blocker || blocker.distance < hover.blocker->distance) hover.blocker = blocker;
  }
  return hover;
}

FaceFigures face_figures(const PartModel& model, const Classification& result,
                         std::span<const FacetIndex> face) {
  FaceFigures figures{.areas = {}, .least_draft_deg = 90.0, .most_draft_deg = -90.0};
  for (const FacetIndex facet : face) {
    const double area = model.geometry.areas[facet];
    if (area <= 0.0) continue;
    for (const Region region : k_regions)
      figures.areas[region] += area * result.facet_fractions[facet][static_cast<std::size_t>(region)];
    const double draft = draft_angle_deg(model.geometry.normals[facet], result.direction);
    figures.least_draft_deg = std::min(figures.least_draft_deg, draft);
    figures.most_draft_deg = std::max(figures.most_draft_deg, draft);
  }
  return figures;
}

std::vector<ViewSegment> outline_of(const PartModel& model, const Faces& faces, std::uint32_t number) {
  const TriangleMesh& mesh = model.part.mesh;
  std::vector<ViewSegment> outline;
  for (const FacetIndex facet : faces.facets(number)) {
    for (int edge = 0; edge < 3; ++edge) {
      const FacetIndex across = model.adjacency.across[facet][static_cast<std::size_t>(edge)];
      if (across != k_no_facet && faces.of_facet[across] == number) continue;
      outline.push_back({model.frame.to_unit(mesh.corner(facet, edge)),
                         model.frame.to_unit(mesh.corner(facet, (edge + 1) % 3))});
    }
  }
  return outline;
}

}  // namespace moldlight::gui
