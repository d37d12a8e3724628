// Caps of directions around the cells that a proof left open.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "proof/direction_proof.hpp"

namespace moldlight {

/// All directions within `radius_deg` of `direction` (unit, z >= 0) or of its opposite.
struct DirectionCap {
  glm::dvec3 direction{0, 0, 1};
  double radius_deg = 0.0;
  double share = 0.0;  // of the half-sphere: the cells in it
  double bound = 0.0;  // the least of its cells, model units squared
};

/// Caps that contain all cells which are not proved, largest share first. Cells that touch are in one cap,
/// across the equator, too, unless a few smaller caps hold them much more tightly.
[[nodiscard]] std::vector<DirectionCap> open_caps(std::span<const ProofCell> cells);

}  // namespace moldlight
