// The surface in which the mold's halves meet outside of the part's shadow: around it and in its holes.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "parting/hull/meeting_heights.hpp"
#include "parting/hull/mold_fault.hpp"
#include "parting/hull/sheets.hpp"
#include "parting/hull/wished_walls.hpp"

namespace moldlight {

/// Facets of the surface narrower than this share of the part's diagonal are rounding, whatever their slope.
inline constexpr double k_narrow = 1e-5;
/// How far in the plane upright walls may be from where their ends stand, in tolerances.
inline constexpr double k_wall_reach = 4.0;

/// In the mold's frame.
struct SurfaceWish {
  glm::dvec2 low{0.0}, high{0.0};  // the block's rectangle, on the grid of columns
  double height = 0.0;             // where the halves are to meet if they can
  double slope = 1.7320508;        // tangent of the greatest slope
  double tolerance = 1e-7;
  double cone_margin = 0.0;                // over 0: cones in the corners, sized for a block with this margin
  std::span<const WishedWall> walls = {};  // what a half is to form
  std::span<const LinePiece> line = {};    // where the halves are to meet otherwise
};

/// Adds the sheet `parting` between the block's rectangle and the outline of the sheet `upper`, which stand
/// in columns. Its heights keep between what is below and what is above at the outline where the slope
/// allows, and give walls to the halves that are to form them where that does, too. Edges that would cross
/// others over a segment get a vertex there. Throws Cancelled.
[[nodiscard]] std::optional<MoldFault> add_parting_surface(Sheets& sheets, const SurfaceWish& wish,
                                                           ForcedSlope& forced, const Progress& progress);

}  // namespace moldlight
