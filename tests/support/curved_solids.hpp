// Closed solids from formulas whose parting lines are known: tori, tubes, saddles, plates with holes.
#pragma once

#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

/// A tube of round section whose centre follows `centres`; closed to a ring if `ring`, else with flat ends.
/// `normal` is perpendicular to all of the centre line; sections lie across it, `sides` corners each, the
/// first along `normal`.
struct TubeShape {
  std::vector<glm::dvec3> centres;
  double radius = 1.0, inner_radius = 0.0;  // inner: hollow with open ends, for a tube that is no ring
  glm::dvec3 normal{0, 0, 1};
  int sides = 24;
  bool ring = false;
};
[[nodiscard]] TriangleMesh tube_mesh(const TubeShape& tube);

/// About z, in `around` sections.
[[nodiscard]] TriangleMesh torus_mesh(double radius, double tube_radius, int around, int sides);

/// What lies over an n-gon of this radius between height(x, y) and `thickness` above it: walls are vertical.
[[nodiscard]] TriangleMesh sheet_mesh(int corners, double radius, double thickness,
                                      const std::function<double(double, double)>& height);

/// A plate in the xy-plane with square holes in rows.
[[nodiscard]] TriangleMesh plate_with_holes(int rows, int columns, double thickness);

}  // namespace moldlight::test
