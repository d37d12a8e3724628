// How often a closed surface winds around a point: whether the point is in the solid.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "mold/exact/projection_grid.hpp"

namespace moldlight {

/// In double, by the facets above the point along a direction that no part's own is likely to be. Immutable,
/// so that any number of threads may ask it.
class SolidProbe {
 public:
  /// The mesh must be closed, its vertices shared, and outlive this.
  explicit SolidProbe(const TriangleMesh& mesh);

  /// Bodies that the point lies in; what is less than about 1e-12 of the mesh's size from a facet may count
  /// as on either side of it.
  [[nodiscard]] int winding(const glm::dvec3& point) const;

 private:
  const TriangleMesh& mesh_;
  glm::dmat3 turn_;
  std::vector<glm::dvec3> turned_;  // the vertices, the direction upward
  ProjectionGrid grid_;
};

}  // namespace moldlight
