// Facets that cross, by signs in whole numbers: nothing of it is shared with the program.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

/// Pairs of facets of which an edge of one runs through the inside of the other. Coordinates are taken to
/// whole multiples of a 2^38th of the greatest, which those in single precision are but for the smallest.
[[nodiscard]] std::size_t exactly_crossing_pairs(const TriangleMesh& mesh);

}  // namespace moldlight::test
