// Facet area by the line along its normal, in cells of a tenth of a degree: what the searches over normals
// run on.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/facet_geometry.hpp"

namespace moldlight {

struct NormalCell {
  glm::dvec3 normal{0};  // unit, area-weighted mean, on the half-sphere of half_sphere()
  double area = 0.0;     // of facets with this normal or the opposite one
};

/// Cells with area, largest first.
[[nodiscard]] std::vector<NormalCell> normal_histogram(const FacetGeometry& geometry);

/// Area-weighted mean line of the cells within `radius_deg` of `normal`, and their area.
[[nodiscard]] NormalCell mean_normal(const std::vector<NormalCell>& cells, const glm::dvec3& normal,
                                     double radius_deg);

}  // namespace moldlight
