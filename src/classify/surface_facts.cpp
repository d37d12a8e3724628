#include "classify/surface_facts.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "classify/classifier.hpp"
#include "mold/exact_rays.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

/// Around a point, of which the shortest span is taken: an odd number, so that none is another one backwards.
constexpr int k_span_ways = 61;
constexpr double k_level = 1e-6;  // of a cross product; a shorter one has no direction

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

std::optional<CutSpan> cut_span(const PartModel& model, const CutPlane& plane, const glm::dvec3& direction,
                                const glm::dvec3& point) {
  const glm::vec3 from(point);
  std::optional<CutSpan> shortest;
  std::vector<glm::dvec3> walls;  // their normals, where the shortest span ends
  const auto try_way = [&](const glm::dvec3& along) {
    const glm::vec3 way(along);
    const auto ahead = model.rays().first_hit(from, way, false),
               behind = model.rays().first_hit(from, -way, false);
    if (!ahead || !behind) return;
    const double length = (ahead->distance + behind->distance) * model.frame.diagonal;
    if (shortest && shortest->length <= length) return;
    walls = {model.geometry.normals[ahead->facet], model.geometry.normals[behind->facet]};
    // Walls look away from material.
    shortest = CutSpan{length, glm::dot(walls[0], along) > 0.0, from - behind->distance * way,
                       from + ahead->distance * way};
  };
  const glm::dvec3 level = glm::cross(plane.normal, direction);
  if (glm::length(level) > k_level) {
    try_way(glm::normalize(level));
    return shortest;
  }
  for (const glm::dvec3& way : ring_around(plane.normal, 90.0, k_span_ways, 0.0)) try_way(way);
  // Straight across the walls that were found, to the last digit.
  for (const glm::dvec3& wall : std::vector(walls)) {
    const glm::dvec3 across = wall - glm::dot(wall, plane.normal) * plane.normal;
    if (glm::length(across) > k_level) try_way(glm::normalize(across));
  }
  return shortest;
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

std::vector<glm::vec3> surroundings(const PartModel& model, std::span<const FacetIndex> face) {
  constexpr double k_reach = 0.8, k_least_reach = 0.1;  // from the middle; of the face's size, unit frame
  Bounds box;
  for (const FacetIndex facet : face) {
    for (const VertexIndex corner : model.part.mesh.facets[facet])
      box.add(glm::dvec3(model.frame.to_unit(model.part.mesh.vertices[corner])));
  }
  const double reach = std::max(k_reach * box.diagonal(), k_least_reach);
  return points_around(glm::vec3(box.center()), reach);
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

MeasuredPlace measured_place(const PartModel& model, const PickedPoint& point) {
  return {glm::dvec3(point.position) * model.frame.diagonal + model.frame.center,
          model.geometry.normals[point.facet]};
}

MeasuredPair measured(const MeasuredPlace& a, const MeasuredPlace& b, const glm::dvec3& direction) {
  constexpr double k_parallel_deg = 0.5;
  const glm::dvec3 way = b.at - a.at;
  MeasuredPair pair;
  pair.distance = glm::length(way);
  pair.along = std::abs(glm::dot(way, direction));
  pair.across = glm::length(glm::cross(way, direction));
  pair.angle_deg =
      glm::degrees(std::atan2(glm::length(glm::cross(a.normal, b.normal)), glm::dot(a.normal, b.normal)));
  if (std::min(pair.angle_deg, 180.0 - pair.angle_deg) < k_parallel_deg)
    pair.between_planes = std::abs(glm::dot(way, a.normal));
  return pair;
}

}  // namespace moldlight
