// Round walls that stand upright, though CAD programs cut them so that their facets lean a little to either
// side, where a hole runs into them or their ends are divided otherwise.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/sheet_frame.hpp"

namespace moldlight {

struct UprightPart {
  TriangleMesh mesh;
  std::vector<FacetIndex> facet_of;  // of the part, of which each of its facets is
};

/// All corners of such a wall lie on it: its facets, and those beside it, are divided at all of them. By that
/// the part is larger or smaller by less than `reach`, in diagonals, at a place. None where no facet leans,
/// or where others would turn over. Throws Cancelled.
[[nodiscard]] std::optional<UprightPart> with_divided_walls(const TriangleMesh& mesh, const SheetFrame& frame,
                                                            double reach, const Progress& progress);

}  // namespace moldlight
