// A part whose walls stand exactly upright where they lean by rounding, or by how a round wall was cut into
// facets.
#pragma once

#include <optional>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/round_walls.hpp"
#include "parting/sheet_frame.hpp"

namespace moldlight {

/// Walls that lean by rounding, by less than 1e-5 of the diagonal, have their vertices moved across the
/// direction by less than 2e-5 of it; then round walls are divided as with_divided_walls() says. None where
/// all such walls stand upright already, or cannot. Throws Cancelled.
[[nodiscard]] std::optional<UprightPart> with_upright_walls(const TriangleMesh& mesh, const SheetFrame& frame,
                                                            double reach, const Progress& progress);
[[nodiscard]] UprightPart part_as_it_is(TriangleMesh mesh);

}  // namespace moldlight
