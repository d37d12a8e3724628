// The plane outside of the part's shadow as triangles, with the outline's points in columns of the sheets.
#pragma once

#include <optional>
#include <vector>

#include "parting/halves/plane_mesh.hpp"
#include "parting/halves/sheets.hpp"

namespace moldlight {

struct SegmentCut {
  PlanePoint a = 0, b = 0;  // of the segment
  PlanePoint at = 0;
};
/// Every end of a sheet over these segments gets vertices in the columns.
void cut_segments(Sheets& sheets, const std::vector<SegmentCut>& cuts);

struct OutlinePlane {
  PlaneMesh mesh;
  std::vector<PlanePoint> column_of;  // of each point; k_no_plane_point: none

  OutlinePlane(const glm::dvec2& low, const glm::dvec2& high)
      : mesh(low, high), column_of(4, k_no_plane_point) {}
};

/// The rectangle with the outline of the sheet `upper`, whose columns within `tolerance` of a segment, or
/// where two cross, become points of it; fills `plane`, or says why there is no such outline. The plane's z
/// is `height` in what is said.
[[nodiscard]] std::optional<MoldFault> lay_outline(Sheets& sheets, double tolerance, double height,
                                                   OutlinePlane& plane);

/// Puts the points from number `before` on that divide the outline into columns.
void put_in_columns(Sheets& sheets, std::size_t before, double tolerance, OutlinePlane& plane);

}  // namespace moldlight
