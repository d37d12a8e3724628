#include "render/surface_sheets.hpp"

#include "mesh/convex_polygon.hpp"

namespace moldlight {

void SurfaceSheets::add(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
  ConvexPolygon polygon;
  for (const glm::dvec3& corner : corners) polygon.push_back((corner - frame_.center) / frame_.diagonal);
  if (cut_) polygon = parted(polygon, {cut_->normal, cut_->offset}, 0.0).inside;
  const auto first = static_cast<VertexIndex>(body.vertices.size());
  for (const glm::dvec3& corner : polygon)
    body.vertices.push_back({glm::vec3(corner), octahedral(glm::vec3(normal))});
  for (VertexIndex k = 2; k < polygon.size(); ++k) body.facets.push_back({first, first + k - 1, first + k});
}

}  // namespace moldlight
