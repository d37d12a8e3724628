// Builds closed meshes from planar polygons with holes: the way the test parts are made. Triangulates by ear
// clipping.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

using Loop2 = std::vector<glm::dvec2>;
using Loop = std::vector<glm::dvec3>;

[[nodiscard]] double polygon_area(const Loop2& loop);  // signed, counter-clockwise positive
[[nodiscard]] double polygon_perimeter(const Loop2& loop);

/// Regular polygon of `sides` corners at distance `radius`, counter-clockwise, the first at angle `turn_deg`.
[[nodiscard]] Loop2 regular_polygon(int sides, double radius, double turn_deg = 0.0);

/// The loop in the plane z = `z`.
[[nodiscard]] Loop at_height(const Loop2& loop, double z);

class SolidBuilder {
 public:
  /// A planar polygon, counter-clockwise seen from outside the solid; holes in any sense, inside it and
  /// apart.
  void face(const Loop& outer, const std::vector<Loop>& holes = {});

  /// The planar quads between two loops of equal size; outward when the loops run counter-clockwise seen from
  /// `high`.
  void walls(const Loop& low, const Loop& high);

  /// Profiles in the xz-plane (outer counter-clockwise seen along +y, holes in any sense), extruded from y =
  /// 0 to `length`.
  void extrude(const Loop2& outer, const std::vector<Loop2>& holes, double length);

  /// A box; faces listed in `left_out` (0 … 5: -x, +x, -y, +y, -z, +z) are left to the caller.
  void box(const glm::dvec3& low, const glm::dvec3& high, const std::vector<int>& left_out = {},
           bool inward = false);

  /// The welded mesh; checks that it is closed and manifold.
  [[nodiscard]] TriangleMesh mesh() const;

 private:
  std::vector<glm::dvec3> corners_;
};

/// Corners of a box's face (0 … 5 as above), counter-clockwise seen from outside.
[[nodiscard]] Loop box_face(const glm::dvec3& low, const glm::dvec3& high, int face);

}  // namespace moldlight::test
