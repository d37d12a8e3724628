// The outline as segments with the heights at which the parting surface may meet them, and what is assigned
// of these.
#pragma once

#include <span>
#include <vector>

#include "parting/halves/assigned_walls.hpp"
#include "parting/halves/outline_plane.hpp"
#include "parting/halves/shelf_field.hpp"

namespace moldlight {

/// Segments of the outline by the region of the plane that they bound: the first is around the part, the
/// others are its holes.
using RegionRims = std::vector<std::vector<RimSegment>>;

/// Between the highest of what is below and the lowest of what is above each.
[[nodiscard]] RegionRims outline_rims(const Sheets& sheets, const OutlinePlane& plane);

struct RimWishes {
  double height = 0.0;
  std::span<const AssignedWall> walls;
  std::span<const LinePiece> line;
  double tolerance = 1e-7;
};
/// Narrows the ranges to those in which walls are formed as assigned, where there are such.
void keep_walls(const RimWishes& wishes, std::vector<RimSegment>& rims);

/// The field of each region: where a level meets all of an outline, or a hole's is in one plane, it is that;
/// where steps across the plane meet it, and more of them is one plane than of a shelf with its ramps, these.
[[nodiscard]] std::vector<ShelfField> shelf_fields(const RegionRims& rims, const RimWishes& wishes,
                                                   const ShelfShape& shape, const Progress& progress);

/// Adds points and segments outside of the outline, where the fields of the regions bend, and puts those on
/// the outline into columns.
void lay_shelf(Sheets& sheets, std::span<const ShelfField> fields, double tolerance, OutlinePlane& plane);

}  // namespace moldlight
