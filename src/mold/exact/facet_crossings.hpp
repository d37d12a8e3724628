// Where the facets of a mesh cross each other: overlapping bodies and surfaces that run through themselves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A segment on a facet, where another facet crosses it. Unit frame.
struct FacetCrossing {
  glm::dvec3 start, end;
};

struct FacetCrossings {
  std::vector<FacetCrossing> crossings;  // by facet
  std::vector<std::uint32_t> first;      // facets + 1 entries: those of facet k are [first[k], first[k + 1])
};

/// Every pair of facets that cross in a segment, found by a tree of boxes; facets that touch or lie in one
/// plane do not cross. `positions` in the unit frame, `normals` of the facets. Uses all cores; the result
/// does not depend on them. Throws Cancelled.
[[nodiscard]] FacetCrossings facet_crossings(const TriangleMesh& mesh, std::span<const glm::dvec3> positions,
                                             std::span<const glm::dvec3> normals, const Progress& progress);

/// The part of triangle `a` that lies in triangle `b`, where their planes cross; false if there is none.
/// `normal_b` is b's unit normal. The segment may reach beyond `b` by its `slack`.
struct CrossingQuery {
  const glm::dvec3* a;  // three corners
  const glm::dvec3* b;  // three corners
  glm::dvec3 normal_b{0, 0, 1};
  double slack = 1e-9;
};
[[nodiscard]] bool triangle_crossing(const CrossingQuery& query, FacetCrossing& crossing);

}  // namespace moldlight
