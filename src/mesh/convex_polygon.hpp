// Flat convex polygons in space and what is cut from them.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

/// Corners in order; three or more for a polygon that has any area.
using ConvexPolygon = std::vector<glm::dvec3>;

[[nodiscard]] double polygon_area(const ConvexPolygon& polygon);
[[nodiscard]] glm::dvec3 polygon_centre(const ConvexPolygon& polygon);  // of its area

/// How far its corners reach from a point.
[[nodiscard]] double reach_from(const glm::dvec3& point, const ConvexPolygon& polygon);
/// From the nearest point of the segment from `a` to `b`.
[[nodiscard]] double distance_to_segment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b);

/// Where normal · x <= offset.
struct HalfSpace {
  glm::dvec3 normal{0.0, 0.0, 1.0};  // unit
  double offset = 0.0;
};

/// Signed distance from its plane, above 0 outside.
[[nodiscard]] double beyond(const glm::dvec3& point, const HalfSpace& half);

/// What of a polygon is inside and outside; corners within `rounding` of the plane are in both.
struct PartedPolygon {
  ConvexPolygon inside, outside;
};
[[nodiscard]] PartedPolygon parted(const ConvexPolygon& polygon, const HalfSpace& half, double rounding);

/// How far around a triangle is near it: off its plane, and beyond its rim.
struct Nearness {
  double normal = 0.0, lateral = 0.0;
};
/// A convex body around a triangle with this unit normal that holds what is near it, and nothing that is
/// farther beyond its corners than some half more.
using TriangleHull = std::array<HalfSpace, 8>;
[[nodiscard]] TriangleHull hull_around(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal,
                                       const Nearness& nearness);

/// How a polygon lies to a hull; `rounding` is a length that does not count.
enum class HullSide { inside, outside, across };
[[nodiscard]] HullSide side_of(const ConvexPolygon& polygon, const TriangleHull& hull, double rounding);

/// The part of the polygon in the hull, which may be none; the rest goes to `outside` in convex pieces. Where
/// nothing is in the hull, that is the polygon whole.
[[nodiscard]] ConvexPolygon cut_by(const ConvexPolygon& polygon, const TriangleHull& hull, double rounding,
                                   std::vector<ConvexPolygon>& outside);

/// Whether their rims come as near to each other as `reach`.
[[nodiscard]] bool rims_touch(const ConvexPolygon& a, const ConvexPolygon& b, double reach);

}  // namespace moldlight
