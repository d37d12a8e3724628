// Walls that stand upright but for the rounding of the file: half of the facets of such a wall would be seen
// from above, and the parting surface would have to climb the wall between two of them.
#pragma once

#include <optional>

#include "mesh/triangle_mesh.hpp"
#include "parting/part_sheets.hpp"

namespace moldlight {

/// The mesh with these walls exactly upright, its facets in their order: vertices move across the direction
/// alone, by less than 2e-5 of the diagonal. None where all such walls stand upright already, or cannot.
[[nodiscard]] std::optional<TriangleMesh> with_upright_walls(const TriangleMesh& mesh,
                                                             const SheetFrame& frame);

}  // namespace moldlight
