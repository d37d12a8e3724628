#include "gui/view/surface.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "classify/classifier.hpp"
#include "classify/classify_report.hpp"
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
    const auto hit = model.rays().first_hit(origin, glm::vec3(above ? direction : -direction), true);
    if (!hit) continue;
    const Blocker blocker{hit->facet, hit->distance * model.frame.diagonal, above};
    if (!hover.blocker || blocker.distance < hover.blocker->distance) hover.blocker = blocker;
  }
  return hover;
}

std::optional<ChosenFace> face_of(const PartModel& model, FacetIndex facet) {
  const std::vector<std::uint32_t>& sources = model.part.facet_source;
  if (sources.empty() || sources[facet] == k_no_facet) return std::nullopt;
  ChosenFace face{.number = sources[facet], .facets = {}, .figures = {}};
  for (FacetIndex other = 0; other < sources.size(); ++other) {
    if (sources[other] == face.number) face.facets.push_back(other);
  }
  return face;
}

std::optional<SourceAreas> face_figures(const PartModel& model, const Classification& result,
                                        std::uint32_t number) {
  const std::vector<SourceAreas> all = face_areas(model, result);
  const auto found = std::ranges::find(all, number, &SourceAreas::source);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::vector<ViewSegment> outline_of(const PartModel& model, const ChosenFace& face) {
  const TriangleMesh& mesh = model.part.mesh;
  const std::vector<std::uint32_t>& sources = model.part.facet_source;
  std::vector<ViewSegment> outline;
  for (const FacetIndex facet : face.facets) {
    for (int edge = 0; edge < 3; ++edge) {
      const FacetIndex across = model.adjacency.across[facet][static_cast<std::size_t>(edge)];
      if (across != k_no_facet && sources[across] == face.number) continue;
      outline.push_back({model.frame.to_unit(mesh.corner(facet, edge)),
                         model.frame.to_unit(mesh.corner(facet, (edge + 1) % 3))});
    }
  }
  return outline;
}

}  // namespace moldlight::gui
