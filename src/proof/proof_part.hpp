// Facts about a part that proofs over cells of directions need.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mold/exact_rays.hpp"

namespace moldlight {

/// Everything must outlive the proof. Adjacency, geometry and rays are those of the mesh.
struct ProofPart {
  const TriangleMesh& mesh;
  const FacetGeometry& geometry;
  const Adjacency& adjacency;
  const std::vector<glm::dvec3>& positions;  // of the vertices, unit frame
  const ExactRays& rays;
};

}  // namespace moldlight
