// A fixed set of points on the part's surface, from which areas are measured.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"

namespace moldlight {

/// A point of the surface in the unit frame. Laid out as the sample pass reads it: 16 bytes.
struct SurfaceSample {
  glm::vec3 position;
  FacetIndex facet;
};
static_assert(sizeof(SurfaceSample) == 16);

/// Samples ordered by facet: those of facet k are [first[k], first[k + 1]); each stands for an equal share of
/// its facet's area.
struct SurfaceSamples {
  std::vector<SurfaceSample> samples;
  std::vector<std::uint64_t> first;  // facets + 1 entries
};

/// Place number `index` in the unit square: consecutive numbers fill it evenly (additive recurrence of the
/// plastic number, Roberts 2018).
[[nodiscard]] glm::dvec2 square_place(std::uint64_t index);

/// Place number `index` in a triangle a, b, c: the point a + u (b - a) + v (c - a). The places of consecutive
/// numbers fill the triangle evenly (those of the square, folded).
struct TrianglePlace {
  double u = 0.0, v = 0.0;

  [[nodiscard]] glm::dvec3 in(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    return a + u * (b - a) + v * (c - a);
  }
};
[[nodiscard]] TrianglePlace triangle_place(std::uint64_t index);

/// Facets get samples in proportion to their areas, `wanted` over the whole part, but four at least (none
/// without area). Within a facet they follow the additive recurrence of the plastic number (Roberts 2018),
/// folded into the triangle, from a start that depends on the facet's number alone.
[[nodiscard]] SurfaceSamples sample_surface(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                            const UnitFrame& frame, std::uint64_t wanted);

/// Samples of equal weight: `count` over the whole part in proportion to area, none on facets too small to
/// get one. Facet boundaries are passed over, so that many small facets share a sample.
[[nodiscard]] SurfaceSamples sample_surface_evenly(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                                   const UnitFrame& frame, std::uint64_t count);

}  // namespace moldlight
