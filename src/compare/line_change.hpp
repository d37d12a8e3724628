// Where a revision's parting line leaves that of the mold that exists.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "parting/loops.hpp"

namespace moldlight {

/// A run of one line that is off the other. Lengths are in the part's unit.
struct LineStretch {
  double length = 0.0;
  double farthest = 0.0;  // from the other line; the part's diagonal where there is none
  glm::dvec3 at{0.0};     // where it is farthest
};

struct LineChange {
  double within = 0.0;                   // nearer than this it is the same line
  std::vector<LineStretch> fresh, gone;  // of B's line off A's, and of A's off B's; the longest first
};

/// Of what core and cavity meet in; `within` > 0.
[[nodiscard]] LineChange find_line_change(const PartingLine& a, const PartingLine& b, double within,
                                          double diagonal);

}  // namespace moldlight
