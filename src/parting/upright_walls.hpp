// A part whose walls stand exactly upright where they lean by rounding, or by how a round wall was cut into
// facets.
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

/// Walls that lean by rounding, by less than 1e-5 of the diagonal, have their vertices moved across the
/// direction by less than 2e-5 of it. CAD programs cut round walls so that facets lean a little to either
/// side, where a hole runs into them or their ends are divided otherwise, though all their corners lie on the
/// wall: such facets, and those beside them, are divided at all these corners, by which the part is larger or
/// smaller by less than `reach` (in diagonals) at a place. None where all such walls stand upright already,
/// or cannot. Throws Cancelled.
[[nodiscard]] std::optional<UprightPart> with_upright_walls(const TriangleMesh& mesh, const SheetFrame& frame,
                                                            double reach, const Progress& progress);

}  // namespace moldlight
