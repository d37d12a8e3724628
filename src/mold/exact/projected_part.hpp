// A part seen along a parting direction: what may hide surface, and the edges under which that changes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mold/exact/exact_part.hpp"
#include "mold/exact/projection_grid.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

/// Which way a surface point looks: +1 along the direction, -1 against it.
using Sense = int;

/// A contour edge; the strip that hangs from it along the direction is its curtain.
struct ContourEdge {
  glm::dvec3 start{0.0}, along{0.0};  // end - start
  glm::dvec2 across{0.0};             // unit normal of the curtain, in the projection
  double per_length = 0.0;            // 1 / length of the projection
  bool up = false, down = false;      // whether facets that face up, or down, end here
};

/// Coordinates are those of the unit frame, turned so that z is the direction. The part must outlive it.
class ProjectedPart {
 public:
  ProjectedPart(const ExactPart& part, const glm::dvec3& direction);

  [[nodiscard]] const ExactPart& part() const { return *part_; }
  [[nodiscard]] const MapFrame& frame() const { return frame_; }
  [[nodiscard]] const glm::dvec3& point(VertexIndex vertex) const { return points_[vertex]; }
  [[nodiscard]] glm::dvec3 turned(const glm::dvec3& unit) const {
    return {glm::dot(frame_.x, unit), glm::dot(frame_.y, unit), glm::dot(frame_.z, unit)};
  }
  /// +1 for a facet that faces up, -1 for down, 0 for one that is seen from neither side.
  [[nodiscard]] Sense facing(FacetIndex facet) const { return facing_[facet]; }
  [[nodiscard]] const std::vector<ContourEdge>& contour() const { return contour_; }
  [[nodiscard]] const ProjectionGrid& contour_grid() const { return contour_grid_; }
  [[nodiscard]] const ProjectionGrid& facet_grid() const { return facet_grid_; }

  /// True if a facet lies beyond the point: one that faces it, or with `any` one that faces either way. A
  /// facet that touches the point counts.
  [[nodiscard]] bool blocked(const glm::dvec3& point, Sense sense, bool any) const;

 private:
  void find_contour();

  const ExactPart* part_;
  MapFrame frame_;
  std::vector<glm::dvec3> points_;
  std::vector<std::int8_t> facing_;
  std::vector<ContourEdge> contour_;
  ProjectionGrid contour_grid_, facet_grid_;
};

}  // namespace moldlight
