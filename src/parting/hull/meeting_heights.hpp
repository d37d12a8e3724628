// Heights of the parting surface over a triangulated plane: as near to what is wished as a greatest slope
// allows (the two envelopes of McShane 1934), and facets by projections onto the slope (Bregman 1965).
#pragma once

#include <cmath>
#include <vector>

#include <glm/vec3.hpp>

#include "parting/hull/plane_mesh.hpp"

namespace moldlight {

struct HeightRange {
  double low = -INFINITY, high = INFINITY;
};

/// Ranges are one a point of the mesh, each the more to be kept.
struct HeightWishes {
  double height = 0.0;            // of all that no range asks otherwise for
  double slope = 1.0;             // tangent, over 0
  std::vector<HeightRange> line;  // heights between these places are between theirs
  std::vector<HeightRange> hand, part;
};

/// What the ranges of the part force any surface outside of the outline to do, whatever its facets: from one
/// place to the other it must be that steep somewhere.
struct ForcedSlope {
  double tangent = 0.0;  // infinite where the places are above each other; 0: not more than was asked
  glm::dvec3 high{0.0}, low{0.0};
};

struct MeetingHeights {
  std::vector<double> z;  // one a point
  ForcedSlope forced;
};

/// For the triangles that are not inside. No facet wider than `narrow` is steeper than asked; where ranges
/// would force it to be, heights leave them, about as much above as below.
[[nodiscard]] MeetingHeights meeting_heights(const PlaneMesh& mesh, const HeightWishes& wishes,
                                             double narrow);

}  // namespace moldlight
