// The truth about regions, slowly: Moeller-Trumbore rays against every facet from stratified samples of each
// facet.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"
#include "support/shapes.hpp"

namespace moldlight::test {

/// Region of the point `point` on a facet with unit normal `normal`; the facet itself never hides it.
[[nodiscard]] Region brute_force_region(const TriangleMesh& mesh, FacetIndex facet, const glm::dvec3& point,
                                        const glm::dvec3& normal, const glm::dvec3& direction,
                                        const ShapeSettings& settings);

/// Areas from about `samples` samples (one a facet at least), and twice their standard errors.
struct BruteForceAreas {
  RegionValues areas;
  RegionValues two_errors;
};
[[nodiscard]] BruteForceAreas brute_force_areas(const TriangleMesh& mesh, const glm::dvec3& direction,
                                                const ShapeSettings& settings, std::size_t samples,
                                                std::uint32_t seed);

}  // namespace moldlight::test
