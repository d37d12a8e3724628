// What a picture needs of the part beside PartBuffers, made once on the CPU: on any thread, without GL.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/edges.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/draft.hpp"

namespace moldlight {

/// A corner as the geometry pass reads it: 16 bytes.
struct ViewVertex {
  glm::vec3 position;                  // unit frame
  std::array<std::int16_t, 2> normal;  // octahedral, of the smooth surface
};
static_assert(sizeof(ViewVertex) == 16);

struct ViewSegment {
  glm::vec3 start, end;  // unit frame
};

struct ViewGeometry {
  std::vector<ViewVertex> vertices;
  std::vector<std::array<VertexIndex, 3>> facets;  // facet k is facet k of the mesh
  std::vector<ViewSegment> feature_edges;
  std::vector<glm::vec3> extremes;  // outermost vertices in a few hundred directions, unit frame: enough to
                                    // frame a picture by
  bool closed = false;  // every facet has a neighbour across each edge, so that no back is ever seen
};
[[nodiscard]] ViewGeometry view_geometry(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                         const Adjacency& adjacency, const UnitFrame& frame);

/// Those of `edges` (the concave or the convex ones) that are contour edges of a direction: up on one side,
/// down on the other; near-vertical facets count as both. `classes` are those for the direction.
[[nodiscard]] std::vector<ViewSegment> contour_edges(const TriangleMesh& mesh,
                                                     std::span<const FacetEdge> edges,
                                                     std::span<const FacetClass> classes,
                                                     const UnitFrame& frame);

/// A vector of any length but zero on the octahedron, folded into a square (Cigolle et al. 2014), in steps of
/// 1 / 32767.
[[nodiscard]] std::array<std::int16_t, 2> octahedral(const glm::vec3& vector);
/// The unit vector back from it.
[[nodiscard]] glm::vec3 from_octahedral(const std::array<std::int16_t, 2>& steps);

}  // namespace moldlight
