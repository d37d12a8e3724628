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

/// A body cut at heights as a printer slices it.
struct SectionCheck {
  std::size_t sections = 0;
  std::size_t open = 0;      // places where an outline does not go on
  std::size_t crossing = 0;  // pairs of an outline's lines that cross by more than rounding
};
/// Cuts along z, `spacing` apart, from half of it above the lowest point.
[[nodiscard]] SectionCheck check_sections(const TriangleMesh& body, double spacing);

}  // namespace moldlight::test
