// Closed parts of our own whose region areas are known in closed form, for the truth of accessibility: up
// facets look along +d, down facets along -d, near-vertical ones along both from p + delta h.
#pragma once

#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight::test {

/// The parts are some 30 units long; no feature but those that say so is smaller than 1 unit.
struct ShapeSettings {
  double tau_deg = 1.0;             // (0, 3]
  double lateral_tolerance = 0.02;  // delta in model units, (0, 0.4]
};

struct Shape {
  std::string name;
  TriangleMesh mesh;  // closed, manifold, outward
  glm::dvec3 direction{0, 0, 1};
  RegionValues expected;  // areas for the settings it was made with, exact up to rounding
  ShapeSettings settings;
};

[[nodiscard]] Shape box_shape(const ShapeSettings& settings);
[[nodiscard]] Shape cup(const ShapeSettings& settings);
[[nodiscard]] Shape cup_with_side_hole(const ShapeSettings& settings);
[[nodiscard]] Shape plate_with_side_pocket(const ShapeSettings& settings);  // blind: hidden from both sides
[[nodiscard]] Shape plate_with_through_hole(
    const ShapeSettings& settings);  // along the direction: no undercut
[[nodiscard]] Shape block_with_crossing_hole(const ShapeSettings& settings);

[[nodiscard]] Shape spool(const ShapeSettings& settings);  // the small upper flange hides part of the lower
[[nodiscard]] Shape hollow_sphere(const ShapeSettings& settings);  // inner void: undercut for every direction
[[nodiscard]] Shape ring(const ShapeSettings& settings);  // a torus of facets: core above, cavity below
[[nodiscard]] Shape stepped_shaft(const ShapeSettings& settings);      // lies on its side
[[nodiscard]] Shape frustum_under_tau(const ShapeSettings& settings);  // walls of 0.98 tau: near-vertical
[[nodiscard]] Shape frustum_over_tau(const ShapeSettings& settings);   // walls of 1.02 tau: up

[[nodiscard]] Shape thin_rib(const ShapeSettings& settings);  // 0.6 units thick
[[nodiscard]] Shape v_notch(const ShapeSettings& settings);
[[nodiscard]] Shape snap_hook(const ShapeSettings& settings);  // over a closed floor: undercut
[[nodiscard]] Shape snap_hook_past_edge(
    const ShapeSettings& settings);  // past the end of the floor: no undercut
[[nodiscard]] Shape l_bracket(const ShapeSettings& settings);
[[nodiscard]] Shape oblique_l_bracket(
    const ShapeSettings& settings);  // direction 20 degrees off: a cast shadow
[[nodiscard]] Shape t_bar(const ShapeSettings& settings);
[[nodiscard]] Shape t_slot(const ShapeSettings& settings);
[[nodiscard]] Shape dovetail_slot(const ShapeSettings& settings);
[[nodiscard]] Shape narrow_ledge(
    const ShapeSettings& settings);  // half delta wide: the wall above it is `both`
[[nodiscard]] Shape wide_ledge(
    const ShapeSettings& settings);  // twice delta wide: the wall above it is `core`

/// Part and direction turned together: the same areas.
[[nodiscard]] Shape turned(Shape shape, const glm::dquat& rotation);

/// The same shape in more facets (see subdivided).
[[nodiscard]] Shape refined(Shape shape, std::size_t target_facets);

/// All of the above, irregularly subdivided into a few hundred facets; each also turned by a rotation of its
/// own.
[[nodiscard]] std::vector<Shape> all_shapes(const ShapeSettings& settings);

}  // namespace moldlight::test
