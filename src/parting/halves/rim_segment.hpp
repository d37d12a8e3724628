// The outline, piece by piece, and what shape the parting surface that meets it is to have.
#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "parting/halves/plane_mesh.hpp"

namespace moldlight {

/// A segment of the outline, the surface on its left, and between what heights it may be met at the ends.
struct RimSegment {
  std::array<glm::dvec2, 2> ends{};
  std::array<HeightRange, 2> ranges{};

  [[nodiscard]] double length() const { return glm::distance(ends[0], ends[1]); }
};

/// Tangents of slopes, and a length.
struct ShelfShape {
  double ramp = 0.57735;     // of ramps
  double slope = 1.7320508;  // the most, where the outline itself is steeper than a ramp
  double land = 0.02;        // level outwards from the outline
};

}  // namespace moldlight
