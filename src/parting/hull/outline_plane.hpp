// The plane outside of the part's shadow as triangles, with the outline's points in columns of the sheets.
#pragma once

#include <optional>
#include <vector>

#include "parting/hull/mold_fault.hpp"
#include "parting/hull/plane_mesh.hpp"
#include "parting/hull/sheets.hpp"

namespace moldlight {

struct OutlinePlane {
  PlaneMesh mesh;
  std::vector<Column> column_of;  // of each point; k_no_column: none

  OutlinePlane(const glm::dvec2& low, const glm::dvec2& high) : mesh(low, high), column_of(4, k_no_column) {}
};

/// The rectangle with the outline of the sheet `upper`, whose columns within `tolerance` of a segment, or
/// where two cross, become points of it; fills `plane`, or says why there is no such outline. The plane's z
/// is `height` in what is said.
[[nodiscard]] std::optional<MoldFault> lay_outline(Sheets& sheets, double tolerance, double height,
                                                   OutlinePlane& plane);

/// Puts the points from number `before` on that divide the outline into columns.
void put_in_columns(Sheets& sheets, std::size_t before, double tolerance, OutlinePlane& plane);

}  // namespace moldlight
