// Copies of meshes: moved, turned, scaled, rounded, with facets in another order, with more facets.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

[[nodiscard]] TriangleMesh translated(TriangleMesh mesh, const glm::dvec3& offset);
[[nodiscard]] TriangleMesh scaled(TriangleMesh mesh, double factor);  // about the origin; factor > 0
[[nodiscard]] TriangleMesh rotated(TriangleMesh mesh, const glm::dquat& rotation);
[[nodiscard]] TriangleMesh mirrored(TriangleMesh mesh);          // in x; facets still face outward
[[nodiscard]] TriangleMesh rounded_to_float(TriangleMesh mesh);  // as a binary STL file holds it

/// A rotation that depends on the seed only, uniform over all rotations.
[[nodiscard]] glm::dquat random_rotation(std::uint32_t seed);

/// Facets, vertices and the first corners of facets in an order that depends on the seed only.
[[nodiscard]] TriangleMesh permuted(const TriangleMesh& mesh, std::uint32_t seed);

/// The same surface in `target_facets` facets or one less: long edges are split first, at uneven places, so
/// that facets become irregular but no needles. Closed meshes stay closed. A mesh that has as many facets
/// already stays.
[[nodiscard]] TriangleMesh subdivided(TriangleMesh mesh, std::size_t target_facets);

/// Every facet cut into four at the middles of its edges: facet k becomes facets 4 k to 4 k + 3.
[[nodiscard]] TriangleMesh cut_in_four(const TriangleMesh& mesh);

}  // namespace moldlight::test
