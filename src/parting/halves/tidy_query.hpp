// Limits of what tidying a solid may change.
#pragma once

#include <glm/vec3.hpp>

namespace moldlight {

/// Sine of the angle, 0.01 degrees, from which a facet that leans along a half's pull counts as undercut.
inline constexpr double k_leaning_sine = 1.7453e-4;

struct TidyQuery {
  double tolerance = 0.0;  // how far the surface may move: a few steps of rounding, in the mesh's unit
  glm::dvec3 pull{0.0};    // of a half, unit: no flip may let more of it face along the pull; 0: none
};

}  // namespace moldlight
