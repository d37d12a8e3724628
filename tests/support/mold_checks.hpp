// What the solids of a mold have to be, found by means that made none of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

/// Share of a body's area that is an undercut for its own pull, or that faces it the wrong way, by exact
/// regions at this draft. `lid` is the direction in which its lid faces.
[[nodiscard]] double undercut_share(const TriangleMesh& body, const glm::dvec3& lid, double tau_deg);

/// Facets that cross others.
[[nodiscard]] std::size_t crossed_facets(const TriangleMesh& body);

/// How many of `count` random points of the box around the first body do not lie in exactly one of the
/// bodies, found by how often a line meets each.
[[nodiscard]] std::size_t misplaced_points(std::span<const TriangleMesh> bodies, std::size_t count,
                                           std::uint32_t seed);

/// What is wrong with the outlines of a body at a height: chains that do not close.
[[nodiscard]] std::size_t open_outlines(const TriangleMesh& body, double z);

}  // namespace moldlight::test
