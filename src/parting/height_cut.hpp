// Cuts the free pieces of a split mesh at a height, so that a line between the halves can run there.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// Along `direction` (unit), in the part's coordinates; ends nearer than `tolerance` are not cut off.
struct HeightCut {
  glm::dvec3 direction{0, 0, 1};
  double height = 0.0;
  double tolerance = 0.0;
};

/// The mesh stays conforming: neighbours of what is cut are cut at the shared edges. `free` is kept one entry
/// a piece.
void cut_at_height(SplitMesh& mesh, std::vector<std::uint8_t>& free, const HeightCut& cut);

}  // namespace moldlight
