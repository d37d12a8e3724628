// Where the sections of a part lie.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// Of one part, which must outlive it. Remembers the extent along the normal last asked for: millions of
/// vertices are not gone through for every picture.
class SectionPlanes {
 public:
  SectionPlanes(const TriangleMesh& mesh, const UnitFrame& frame) : mesh_(&mesh), frame_(&frame) {}

  /// The plane for a parting direction (unit); nothing where no section is chosen.
  [[nodiscard]] std::optional<CutPlane> plane(const LookSettings& look, const glm::dvec3& direction);

 private:
  const TriangleMesh* mesh_;
  const UnitFrame* frame_;
  glm::dvec3 normal_{0.0};               // last asked for
  double least_ = 0.0, greatest_ = 0.0;  // of the part along it, unit frame
};

}  // namespace moldlight
