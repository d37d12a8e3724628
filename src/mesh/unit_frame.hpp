// The unit frame: the part moved to the origin and scaled to a diagonal of 1, where single precision is
// enough.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// GL and the ray caster work in this frame, so that neither distance from the origin nor the part's unit
/// costs digits: coordinates are in [-0.5, 0.5] with a rounding of at most 3e-8 of the part's diagonal.
struct UnitFrame {
  glm::dvec3 center{0.0};
  double diagonal = 1.0;  // model units per unit

  [[nodiscard]] glm::vec3 to_unit(const glm::dvec3& model) const {
    return glm::vec3((model - center) / diagonal);
  }
};

/// Frame of a part with these bounds; a part of no extent keeps its scale.
[[nodiscard]] inline UnitFrame unit_frame(const Bounds& bounds) {
  const double diagonal = bounds.diagonal();
  return {.center = bounds.center(), .diagonal = diagonal > 0.0 ? diagonal : 1.0};
}

/// Every vertex of the mesh in the unit frame.
[[nodiscard]] inline std::vector<glm::vec3> unit_positions(const TriangleMesh& mesh, const UnitFrame& frame) {
  std::vector<glm::vec3> positions;
  positions.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices) positions.push_back(frame.to_unit(vertex));
  return positions;
}

}  // namespace moldlight
