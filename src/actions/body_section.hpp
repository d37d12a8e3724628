// How thick a body of a side action is across its way.
#pragma once

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Of a closed body's section across the way (unit), where that is greatest, of the thinnest of its pieces;
/// splinters aside. In the body's unit, squared.
[[nodiscard]] double least_section(const TriangleMesh& body, const glm::dvec3& way);

}  // namespace moldlight
