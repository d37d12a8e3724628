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
  /// What is asked of a facet most often.
  struct Extent {
    float low, high;  // least and greatest z, a little generously
    Sense facing;     // +1 up, -1 down, 0 for a facet that is seen from neither side
  };
  [[nodiscard]] const Extent& extent(FacetIndex facet) const { return extents_[facet]; }
  [[nodiscard]] const std::vector<ContourEdge>& contour() const { return contour_; }
  /// The same of an edge of contour().
  struct ContourExtent {
    float low, high;
    bool up, down;  // whether facets that face up, or down, end here
  };
  [[nodiscard]] const ContourExtent& contour_extent(std::size_t edge) const { return contour_extents_[edge]; }
  [[nodiscard]] const ProjectionGrid& contour_grid() const { return contour_grid_; }
  [[nodiscard]] const ProjectionGrid& facet_grid() const { return facet_grid_; }

  /// Facets that hide surface from a light facing the way `sense` says. In a closed mesh what is nearest to
  /// the light faces it, whether bodies overlap or touch; an open one has no inside, and what faces the ray
  /// from the surface hides it.
  [[nodiscard]] Sense blocker(Sense sense) const { return part_->closed() ? sense : -sense; }
  /// True if a blocker lies beyond a point of a facet.
  [[nodiscard]] bool blocked(const glm::dvec3& point, FacetIndex own, Sense sense) const {
    return blocked_by(point, {.own = own, .sense = sense, .facing = blocker(sense)});
  }
  /// True if any facet, save those seen edge-on, lies beyond a point that is not on the surface.
  [[nodiscard]] bool blocked(const glm::dvec3& point, Sense sense) const {
    return blocked_by(point, {.own = k_no_facet, .sense = sense, .facing = 0});
  }

 private:
  struct Blockers {
    FacetIndex own;  // never one
    Sense sense;
    Sense facing;  // 0: either
  };
  [[nodiscard]] bool blocked_by(const glm::dvec3& point, const Blockers& blockers) const;
  void find_contour();

  const ExactPart* part_;
  MapFrame frame_;
  std::vector<glm::dvec3> points_;
  std::vector<Extent> extents_;
  std::vector<ContourEdge> contour_;
  std::vector<ContourExtent> contour_extents_;
  ProjectionGrid contour_grid_, facet_grid_;
};

}  // namespace moldlight
