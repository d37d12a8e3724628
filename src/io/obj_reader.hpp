// Wavefront OBJ: vertices and polygons. Facets are numbered in the order of the file's polygons ('f' lines);
// a polygon of n corners gives n - 2 facets, as a fan from its first corner unless it is concave.
#pragma once

#include "io/read_context.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Objects are the bodies, or groups where there are no objects. Materials, textures, normals, points, lines
/// and free-form surfaces are left out; no other file is opened. facet_source holds polygon numbers from 0.
[[nodiscard]] Part read_obj(const ReadContext& context);

}  // namespace moldlight
