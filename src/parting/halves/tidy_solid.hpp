// Faults that rounding to single precision leaves in a closed solid, and their removal: fins without
// thickness, needles where the surface is flat, and edges in which the solid touches itself.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"
#include "parting/halves/tidy_query.hpp"

namespace moldlight {

/// Drops pairs of facets with the same corners that face away from each other, and flips edges between facets
/// that are flat within the tolerance where that makes the least angle greater (Lawson 1977), or where less
/// of a half leans along its pull then; thin_facets.hpp takes out what leans by rounding and cannot be
/// flipped. The solid stays closed; the result depends on nothing but the mesh.
void tidy_solid(TriangleMesh& mesh, const TidyQuery& query);

/// Splits vertices so that every edge has two facets and the facets of every vertex hang together: where more
/// than two meet in an edge, those with material between them stay together, and all such pairs but one get a
/// vertex on the edge, so that no edge has more than two facets for readers that join equal vertices either.
/// Returns how many edges had more.
std::size_t split_touching(TriangleMesh& mesh);

}  // namespace moldlight
