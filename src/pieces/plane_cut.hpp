// A solid cut in two by a plane.
#pragma once

#include <optional>
#include <vector>

#include "mesh/convex_polygon.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Closed bodies that share no vertex with each other, on both sides of the plane.
struct CutSolid {
  std::vector<TriangleMesh> inside, outside;
};
/// Coordinates below 4. Nothing where a vertex lies nearly in the plane or where its section is no simple
/// outline.
[[nodiscard]] std::optional<CutSolid> cut_solid(const TriangleMesh& solid, const HalfSpace& half);

}  // namespace moldlight
