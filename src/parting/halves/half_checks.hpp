// Checks of the halves of a mold once they are made.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/halves/sheets.hpp"

namespace moldlight {

/// Facets as seen along z: areas of those that face along a sign, and of the others.
struct GraphTest {
  double covered = 0.0, folded = 0.0, most = 0.0;
  glm::dvec3 place{0.0};  // of the facet that is folded most
};
[[nodiscard]] GraphTest graph_test(const std::vector<glm::dvec3>& vertices,
                                   const std::vector<std::array<SheetVertex, 3>>& facets, double sign);

/// Facets whose least height is below `thinnest`, and a corner of the longest of them.
struct Needles {
  std::size_t count = 0;
  std::optional<glm::dvec3> place;
};
[[nodiscard]] Needles find_needles(const TriangleMesh& mesh, double thinnest);

/// Facets that cross others. Throws Cancelled.
[[nodiscard]] std::vector<FacetIndex> crossed_facets(const TriangleMesh& mesh, const Progress& progress);

}  // namespace moldlight
