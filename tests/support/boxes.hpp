// The smallest closed parts: boxes and unions of boxes as loose triangles, for tests of the mesh layer.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

/// The 36 corners of the 12 outward facets of an axis-aligned box.
[[nodiscard]] std::vector<glm::dvec3> box_corners(const glm::dvec3& low, const glm::dvec3& high);

/// An OBJ file of so many boxes in rows, apart, each a body of its own name: body_1 and on.
[[nodiscard]] std::string obj_of_boxes(int count);

/// A welded box.
[[nodiscard]] TriangleMesh box_mesh(const glm::dvec3& low, const glm::dvec3& high);

/// Both meshes in one, facets of `a` first; no welding.
[[nodiscard]] TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);

/// The same facet seen from the other side; corner 0 stays corner 0.
void reverse_facet(TriangleMesh& mesh, FacetIndex facet);

}  // namespace moldlight::test
