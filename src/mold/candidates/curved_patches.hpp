// Patches of cylinders and cones on a faceted surface: their normals have the same angle to one axis.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"

namespace moldlight {

struct CurvedPatch {
  glm::dvec3 axis{0, 0, 1};  // unit, least-variance direction of the normals
  double area = 0.0;
  double sine_to_axis = 0.0;  // mean of n . axis: 0 for a cylinder
  bool full_turn = false;     // the normals go most of the way round
};

/// Patches that turn by 60 degrees at least, each facet in one patch at most. Facets that lie in one plane
/// are one strip of a patch; neighbouring strips are up to 40 degrees apart.
[[nodiscard]] std::vector<CurvedPatch> curved_patches(const FacetGeometry& geometry,
                                                      const Adjacency& adjacency);

}  // namespace moldlight
