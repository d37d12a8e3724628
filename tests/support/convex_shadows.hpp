// What convex bodies hide, by clipping and adding up plane polygons: the truth about regions of planar faces,
// by another way than cutting facets and testing cells.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mold/region.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight::test {

/// The hull of these points.
using ConvexBody = std::vector<glm::dvec3>;

/// A convex polygon, counter-clockwise seen from outside.
struct PlanarFace {
  Loop corners;
  glm::dvec3 normal;  // unit
};

/// Region areas of the faces in the union of the bodies, exact up to rounding, for the truth of
/// accessibility. A face may lie inside the union: there it is undercut. |n . d| of a face is 0 or at least
/// 1e-4.
[[nodiscard]] RegionValues face_areas(const std::vector<PlanarFace>& faces,
                                      const std::vector<ConvexBody>& bodies, const glm::dvec3& direction,
                                      const ShapeSettings& settings);

/// Area of the shadow of the bodies along the direction.
[[nodiscard]] double shadow_area(const std::vector<ConvexBody>& bodies, const glm::dvec3& direction);

/// Area that convex polygons cover together; each counter-clockwise.
[[nodiscard]] double union_area(const std::vector<Loop2>& polygons);

}  // namespace moldlight::test
