#include "mesh/unit_frame.hpp"

namespace moldlight {

UnitFrame unit_frame(const Bounds& bounds) {
  UnitFrame frame;
  frame.center = bounds.center();
  if (bounds.diagonal() > 0.0) frame.diagonal = bounds.diagonal();
  return frame;
}

std::vector<glm::vec3> unit_positions(const TriangleMesh& mesh, const UnitFrame& frame) {
  std::vector<glm::vec3> positions;
  positions.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices) positions.push_back(frame.to_unit(vertex));
  return positions;
}

}  // namespace moldlight
