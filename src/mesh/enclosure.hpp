// Which components of a mesh lie inside which: ray parity, all rays in one skew direction.
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// For each component of `among`: those others of `among` that enclose it, in rising order. A component
/// encloses another when its box does and most of three points of the other have an odd number of its facets
/// on one side of them. Where surfaces cross or touch the answer is one of the possible ones; it is the same
/// in every run.
[[nodiscard]] std::vector<std::vector<FacetIndex>> enclosing_components(const TriangleMesh& mesh,
                                                                        const Components& components,
                                                                        const std::vector<FacetIndex>& among);

}  // namespace moldlight
