// Welding: one vertex for all corners with the same coordinates.
#pragma once

#include <span>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Mesh of corners.size() / 3 facets, in order. Corners weld when their coordinates are equal (0.0 and -0.0
/// are equal); vertices are numbered in order of first use. `corners` is a multiple of 3 of finite points.
[[nodiscard]] TriangleMesh weld_corners(std::span<const glm::dvec3> corners);

/// The same for an indexed mesh: equal vertices become one, unused ones go, facets keep their order.
[[nodiscard]] TriangleMesh weld_vertices(const TriangleMesh& mesh);

}  // namespace moldlight
