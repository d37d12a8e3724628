// Which facets enclose something.
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// True for the facets of bodies without open edges: facets that hang together over edges, each of which they
/// run through as often in the one sense as in the other. An edge may join more than two of them. Collapsed
/// facets enclose nothing and open nothing.
[[nodiscard]] std::vector<bool> solid_facets(const TriangleMesh& mesh, const Adjacency& adjacency);

}  // namespace moldlight
