// Small meshes for the exact core, made of a few bytes: corners on a coarse grid, so that facets coincide,
// touch and cross, or moved off it a little.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight::fuzz {

enum class MeshKind : std::uint8_t {
  loose_facets,     // any three corners each, wound as they come
  tetrahedra,       // outward, may overlap
  boxes,            // outward, along the axes, may overlap
  open_tetrahedra,  // the first facet is missing
};

struct SmallMesh {
  MeshKind kind = MeshKind::loose_facets;
  double jitter = 0.0;  // how far corners are off the grid, whose planes are 1 apart
  TriangleMesh mesh;    // of up to 35 facets; maybe of none
  glm::dvec3 direction{0, 0, 1};
  test::ShapeSettings settings;  // the lateral tolerance as a share of the diagonal
};

/// Any bytes make a mesh: kind and settings, direction (3), then corners (3 each, of 0 to 7), 3 a facet, 4 a
/// tetrahedron, 2 a box.
[[nodiscard]] SmallMesh small_mesh(std::span<const std::uint8_t> bytes);

}  // namespace moldlight::fuzz
