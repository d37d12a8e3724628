// Parts of our own and revisions of them, and what a comparison says of two.
#pragma once

#include <cmath>
#include <memory>

#include <glm/trigonometric.hpp>

#include "compare/surface_change.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {

using test::at_height;
using test::box_face;
using test::Loop2;
using test::polygon_area;
using test::polygon_perimeter;
using test::regular_polygon;
using test::SolidBuilder;

/// A plate with a round boss on it, and what a revision may change.
struct PlateWithBoss {
  glm::dvec2 boss{-8.0, 1.0};
  double radius = 4.0, height = 10.0, draft_deg = 2.0;  // of the boss, at its foot
  int sides = 48;
  double turn_deg = 0.0;
  double hole_radius = 0.0;  // 0: none
  glm::dvec2 hole{9.0, -2.0};
  double rib = 0.0;  // width of a rib beside the boss; 0: none
};

inline constexpr glm::dvec3 k_plate_low{-20, -12, 0}, k_plate_high{20, 12, 4};
inline constexpr double k_rib_height = 6.0;

inline Loop2 placed(Loop2 loop, const glm::dvec2& at) {
  for (glm::dvec2& corner : loop) corner += at;
  return loop;
}

inline double top_radius(const PlateWithBoss& part) {
  return part.radius - part.height * std::tan(glm::radians(part.draft_deg));
}

inline TriangleMesh plate_mesh(const PlateWithBoss& part) {
  SolidBuilder solid;
  const double top = k_plate_high.z;
  const Loop2 foot = placed(regular_polygon(part.sides, part.radius, part.turn_deg), part.boss);
  const Loop2 head = placed(regular_polygon(part.sides, top_radius(part), part.turn_deg), part.boss);
  solid.walls(at_height(foot, top), at_height(head, top + part.height));
  solid.face(at_height(head, top + part.height));
  std::vector<test::Loop> in_top = {at_height(foot, top)}, in_bottom;
  if (part.hole_radius > 0.0) {
    Loop2 hole = placed(regular_polygon(part.sides, part.hole_radius, part.turn_deg), part.hole);
    in_top.push_back(at_height(hole, top));
    in_bottom.push_back(at_height(hole, 0.0));
    std::reverse(hole.begin(), hole.end());
    solid.walls(at_height(hole, 0.0), at_height(hole, top));
  }
  if (part.rib > 0.0) {
    const Loop2 rib = {{0, 4}, {0 + part.rib, 4}, {0 + part.rib, 10}, {0, 10}};
    in_top.push_back(at_height(rib, top));
    solid.walls(at_height(rib, top), at_height(rib, top + k_rib_height));
    solid.face(at_height(rib, top + k_rib_height));
  }
  solid.box(k_plate_low, k_plate_high, {4, 5});
  solid.face(box_face(k_plate_low, k_plate_high, 5), in_top);
  solid.face(box_face(k_plate_low, k_plate_high, 4), in_bottom);
  return solid.mesh();
}

/// Two parts whose surfaces are laid on each other.
struct Laid {
  std::shared_ptr<const PartModel> a, b;
  Classification a_result, b_result;
  SurfaceChange change;
};

inline Laid laid(const TriangleMesh& a, const TriangleMesh& b, const glm::dvec3& direction = {0, 0, 1}) {
  Laid pair;
  pair.a = test::model_of(a);
  pair.b = test::model_of(b);
  Query query;
  query.direction = direction;
  pair.a_result = classify_exact(*pair.a, query, Progress(), true);
  pair.b_result = classify_exact(*pair.b, query, Progress(), true);
  const OverlaySide side_a(pair.a, pair.a_result), side_b(pair.b, pair.b_result);
  pair.change = find_surface_change(side_a, side_b, usual_tolerance(pair.a->frame.diagonal), Progress());
  return pair;
}

}  // namespace moldlight
