// Takes a straight bar out of a closed solid, as a lifter or a pin is taken out of its half.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/convex_polygon.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// What lies within planes, without an end at `along`, and with one or none at the other side.
struct BarRoom {
  glm::dvec3 along{0, 0, 1};          // unit, about
  std::vector<HalfSpace> sides;       // three or more, each beside those before and after it
  std::optional<HalfSpace> end = {};  // beside all of them
};

/// Closed, without flaw where the solid is: the walls between them are in both, facing away from each other.
struct BarCut {
  TriangleMesh inside, outside;
};
/// `size`: a length of which the solid is some times as large; vertices within 1e-10 of it of a side are in
/// it. Nothing where the solid touches a side in more than its rim, or an edge of the bar in a line.
[[nodiscard]] std::optional<BarCut> cut_by_bar(const TriangleMesh& solid, const BarRoom& room, double size);

}  // namespace moldlight
