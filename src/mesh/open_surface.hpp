// A piece of surface with its border, and the solid between it and an image of it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Manifold with border: an edge has one triangle or two, wound alike, and the triangles at a vertex are one
/// fan.
struct OpenSurface {
  TriangleMesh mesh;
  /// Chains of vertices with the surface on their left, seen from outside; the first is not repeated.
  std::vector<std::vector<VertexIndex>> borders;
  std::vector<VertexIndex> sources;  // of each vertex, in the mesh that it was cut out of
};

/// The triangles with vertices of their own, in the same order. Vertices at which several fans meet are
/// doubled, and edges that more than two triangles share, or two that are not wound alike, come apart.
[[nodiscard]] OpenSurface open_surface(std::span<const glm::dvec3> vertices,
                                       std::span<const std::array<VertexIndex, 3>> triangles);

/// Area vector of what a border encloses: its product with a unit vector is the area that is seen along it,
/// positive where the border runs counter-clockwise when seen from where the vector points to.
[[nodiscard]] glm::dvec3 enclosed_area(const OpenSurface& surface, std::span<const VertexIndex> border);

/// The closed, oriented solid between the surface and its image, vertex k of which is at `image[k]`: the
/// surface turned about, the image, and walls over the borders. What it encloses counts as inside if the
/// image lies outward of the surface.
[[nodiscard]] TriangleMesh solid_between(const OpenSurface& surface, std::span<const glm::dvec3> image);

}  // namespace moldlight
