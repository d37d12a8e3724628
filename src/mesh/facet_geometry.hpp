// Normals and areas of the facets, in double.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// One entry a facet. A facet without area has normal 0 and area 0.
struct FacetGeometry {
  std::vector<glm::dvec3> normals;  // outward unit normals
  std::vector<double> areas;        // model units squared
  double total_area = 0.0;
};

[[nodiscard]] FacetGeometry facet_geometry(const TriangleMesh& mesh);

}  // namespace moldlight
