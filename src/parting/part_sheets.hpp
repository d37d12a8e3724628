// The sheets of a part, from its split mesh: what is seen from above, from below, or hidden.
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mold/exact/split_mesh.hpp"
#include "parting/halves/assigned_walls.hpp"
#include "parting/halves/sheets.hpp"
#include "parting/mold_halves.hpp"
#include "parting/mold_settings.hpp"
#include "parting/sheet_frame.hpp"
#include "parting/through_caps.hpp"
#include "parting/wall_caps.hpp"

namespace moldlight {

/// The tolerance as a share of the part's diagonal, and the width, as a share of it, below which facets as
/// seen along the direction count as upright.
struct SheetTolerance {
  double tolerance = 1e-7, upright = 1.0;
};

/// What is tried, one after the other, until the bodies close.
inline constexpr SheetTolerance k_sheet_attempts[] = {{1e-7, 1.0}, {1e-6, 1.0}, {1e-7, 0.1}, {1e-6, 0.1},
                                                      {2e-6, 1.0}, {1e-8, 1.0}, {1e-8, 0.1}, {1e-7, 0.3},
                                                      {1e-9, 0.1}, {1e-7, 0.0}, {4e-6, 0.1}, {1e-5, 0.1}};

/// The sheets with what the caps add to the part, in cubes of the diagonal.
struct PartSheets {
  Sheets sheets;
  double added = 0.0;
};
/// Those of a mesh; null for none.
struct SheetCaps {
  const WallCaps* walls = nullptr;
  const ThroughCaps* through = nullptr;
};
/// Of a mesh that is split at no draft; its facets from number `beside` on are of other bodies. Upright
/// facets are left out; ends do not stand in columns yet.
[[nodiscard]] PartSheets part_sheets(const SplitMesh& split, FacetIndex beside, const SheetFrame& frame,
                                     const SheetTolerance& attempt, const SheetCaps& caps);

/// Of the facets that a half is to form, the upright ones, and the area of others that it cannot, which lean
/// the other way or are hidden.
struct HandWalls {
  std::vector<AssignedWall> walls;
  std::vector<bool> released;  // whether the half could form the wall where the halves do not meet on it, too
  double assigned_area = 0.0, leaning_area = 0.0;
  std::optional<glm::dvec3> leaning_at;  // where the most of them is
};
/// `assigned`: one a facet of the part. `sheets`: of that split mesh, not divided yet.
[[nodiscard]] HandWalls hand_walls(const SplitMesh& split, const Sheets& sheets,
                                   const std::vector<FacetWish>& assigned, const SheetTolerance& attempt);

/// Where the ends of the sheets `upper` and `lower` do not sum up to nothing over a segment.
[[nodiscard]] std::optional<MoldFault> residual(const Sheets& sheets, double diagonal);

}  // namespace moldlight
