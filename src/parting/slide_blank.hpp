// Blank of a slide: a prism from the part's surface around what the slide forms out to the side of
// the block, drafted, square to its way.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// In the mold's frame about the part's centre, in diagonals of the part.
struct BlankWish {
  const TriangleMesh& part;
  std::vector<const TriangleMesh*> inserts;  // what the slide forms, between the halves
  std::vector<glm::dvec3> formed;            // corners of what of that it forms itself
  bool alone = true;                         // all
  glm::dvec3 way{1, 0, 0};                   // unit, outward, across z
  double shelf = 0.0;                        // height at which the halves meet
  double land = 0.02;                        // around what it forms
  glm::dvec2 low{0.0}, high{0.0};            // of the block, on the grid of columns
};

struct SlideBlank {
  TriangleMesh mesh;    // closed bodies, one on the other; their far ends lie in sides of the block
  glm::dvec3 end{0.0};  // a corner of these ends
  /// Where they lie: in one side, across x or y, or around an edge of the block in two.
  std::array<std::optional<double>, 2> sides;
  std::string refusal;  // why there is none, a clause; empty where there is
};
[[nodiscard]] SlideBlank slide_blank(const BlankWish& wish);

/// How far, and where, something stands in the way of a piece that moves out along its way. Looked at on some
/// 20,000 lines through all of the piece. `reach`: how far it goes. `rim`: what is met no wider than that
/// does not count.
struct WayOut {
  double blocked = 0.0;
  double share = 0.0;  // of the piece's lines, on which something does
  glm::dvec3 place{0.0};
};
[[nodiscard]] WayOut way_out(const TriangleMesh& piece, const TriangleMesh& still, const glm::dvec3& way,
                             double reach = INFINITY, double rim = 0.0);

}  // namespace moldlight
