// A mesh with fewer facets of the same shape, for what has to draw it quickly.
#pragma once

#include <cstddef>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// At most so many facets, or as few as there can be: vertices go into a neighbour, those first that leave
/// the planes of their facets least (Garland and Heckbert 1997, as OpenMesh has it), so planes lose theirs at
/// no cost. No facet turns over, borders, non-manifold edges and vertices of many facets stay, and every
/// vertex is one of the mesh's. Throws Cancelled.
[[nodiscard]] TriangleMesh coarsened(const TriangleMesh& mesh, std::size_t facets, const Progress& progress);

}  // namespace moldlight
