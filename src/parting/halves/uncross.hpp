// Facets of a half that cross others by rounding to single precision, moved apart again.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/halves/tidy_query.hpp"

namespace moldlight {

/// Moves corners of facets that cross others (`crossed`) by a step of rounding or two, first along the pull,
/// along which nothing of what a half covers changes, where fewer facets cross then. No move lets more of the
/// half face or lean along the pull, none touches the sides of the block; the mesh stays as closed as it is.
/// `tolerance` of the query is the longest move. Returns the facets that still cross others. Throws
/// Cancelled.
[[nodiscard]] std::vector<FacetIndex> uncross(TriangleMesh& mesh, const TidyQuery& query,
                                              std::vector<FacetIndex> crossed, const Progress& progress);

}  // namespace moldlight
