// The surface in which the mold's halves meet outside of the part's shadow: around it and in its holes.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "parting/halves/assigned_walls.hpp"
#include "parting/halves/sheets.hpp"
#include "parting/halves/shelf_field.hpp"
#include "parting/halves/slope_limit.hpp"

namespace moldlight {

/// Facets of the surface narrower than this share of the part's diagonal are rounding, whatever their slope.
inline constexpr double k_narrow = 1e-5;

/// In the mold's frame.
struct SurfaceWish {
  glm::dvec2 low{0.0}, high{0.0};  // the block's least rectangle, on the grid of columns
  bool grows = true;               // for a level rim
  double height = 0.0;             // where the halves are to meet if nothing else says
  ShelfShape shape = {};
  double tolerance = 1e-7;
  double cone_margin = 0.0;  // over 0: cones in the corners, sized for a block with this margin
  std::span<const AssignedWall> walls = {};  // what a half is to form
  std::span<const LinePiece> line = {};      // where the halves are to meet otherwise
};

struct PartingSurface {
  glm::dvec2 low{0.0}, high{0.0};  // the block's rectangle: as large as it has to be for a level rim
  ForcedSlope forced;
};

/// Adds the sheet `parting` between the block's rectangle and the outline of the sheet `upper`, which stand
/// in columns: a shelf with land and ramps that keep between what is below and what is above at the outline
/// where the slope allows, and give walls to the halves that are to form them where that does, too. Edges
/// that would cross others over a segment get a vertex there. Throws Cancelled.
[[nodiscard]] std::optional<MoldFault> add_parting_surface(Sheets& sheets, const SurfaceWish& wish,
                                                           PartingSurface& surface, const Progress& progress);

}  // namespace moldlight
