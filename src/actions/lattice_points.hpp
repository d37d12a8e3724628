// Points of the surface of an action's body, at which it is moved against other solids.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Points of a body's surface, a few of them spread evenly.
struct SurfacePoints {
  std::vector<glm::dvec3> few = {}, others = {};
};

/// Where lines of a lattice about the middle of the body's box, along its way and the parting direction, pass
/// its surface, about `count` of them: the same in whatever order its facets are, and of its mirror image the
/// mirrored ones. Every third line each way is among the first few.
[[nodiscard]] SurfacePoints lattice_points(const TriangleMesh& mesh, const glm::dvec3& way,
                                           const glm::dvec3& direction, std::size_t count);

}  // namespace moldlight
