// Facets of a half that are so thin that rounding alone makes them lean along its pull.
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "parting/halves/tidy_query.hpp"

namespace moldlight {

/// Takes such facets out: the shortest edge of each shrinks to one of its ends, where no surface moves by
/// more than the tolerance, none turns over, and no more of it leans along the pull than before. The solid
/// stays closed and an edge that had two facets keeps two; the result depends on nothing but the mesh.
void collapse_thin_facets(TriangleMesh& mesh, const TidyQuery& query);

}  // namespace moldlight
