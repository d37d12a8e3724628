// The surface in which the mold's halves meet outside of the part's shadow: around it and in its holes.
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "parting/hull/mold_fault.hpp"
#include "parting/hull/sheets.hpp"

namespace moldlight {

/// In the mold's frame.
struct SurfaceWish {
  glm::dvec2 low{0.0}, high{0.0};  // the block's rectangle, on the grid of columns
  double height = 0.0;             // where the halves are to meet if they can
  double slope = 1.7320508;        // tangent of the greatest slope
  double tolerance = 1e-7;
  double cone_margin = 0.0;  // over 0: cones in the corners, sized for a block with this margin
};

/// Adds the sheet `parting` between the block's rectangle and the outline of the sheet `upper`, which stand
/// in columns. Its heights keep between what is below and what is above at the outline where the slope
/// allows. Edges that would cross others over a segment get a vertex there.
[[nodiscard]] std::optional<MoldFault> add_parting_surface(Sheets& sheets, const SurfaceWish& wish);

/// Columns put on segments.
struct SegmentCut {
  Column a = 0, b = 0;  // of the segment
  Column at = 0;
};
/// Every end of a sheet over these segments gets vertices in the columns.
void cut_segments(Sheets& sheets, std::vector<SegmentCut> cuts);

}  // namespace moldlight
