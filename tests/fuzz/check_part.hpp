// What must hold for any part that a reader returns, however the file was made.
#pragma once

#include "base/check.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/part.hpp"
#include "mesh/repair.hpp"

namespace moldlight::fuzz {

inline void check_lists(const Part& part) {
  std::size_t covered = 0;
  for (const Body& body : part.bodies) {
    CHECK(body.first_facet == covered && body.facet_count > 0);
    covered += body.facet_count;
  }
  CHECK(covered > 0 && covered == part.mesh.facets.size());
  CHECK(part.facet_source.empty() || part.facet_source.size() == covered);
  CHECK(part.file_facets.empty() || part.file_facets.size() == covered);
  for (const auto& facet : part.mesh.facets) {
    for (const VertexIndex corner : facet) CHECK(corner < part.mesh.vertices.size());
  }
  for (const glm::dvec3& vertex : part.mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) CHECK(vertex[axis] >= -1e30 && vertex[axis] <= 1e30);
  }
}

/// Ends the program where the part breaks a promise; also takes it through health report and repair.
inline void check_part(Part part) {
  check_lists(part);
  const FacetGeometry geometry = facet_geometry(part.mesh);
  const HealthReport before = health_report(part.mesh, geometry);
  CHECK(before.facets == part.mesh.facets.size());
  static_cast<void>(build_adjacency(part.mesh));
  repair_part(part, {.level = RepairLevel::full});
  if (!part.mesh.facets.empty()) check_lists(part);
}

}  // namespace moldlight::fuzz
