// The highest of the surfaces that triangles over one outline make.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

/// Turns edges between the triangles of a polygon, such as a PolygonTriangulator made, until none lies in a
/// valley seen against `up`: over a convex outline the upper hull of its corners. The triangles keep their
/// winding, which is counter-clockwise seen against `up`; those that stand along it stay. Where some lie the
/// other way round, nothing is turned.
void lift_triangles(std::span<const glm::dvec3> corners, const glm::dvec3& up,
                    std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace moldlight
