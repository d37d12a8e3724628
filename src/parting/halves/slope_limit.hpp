// How steep a parting surface is, and is forced to be by the part's own outline: facets are brought down by
// projections onto the slope (Bregman 1965).
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "parting/halves/plane_mesh.hpp"

namespace moldlight {

/// What the ranges of the part force any surface outside of the outline to do, whatever its facets: from one
/// place to the other it must be that steep somewhere.
struct ForcedSlope {
  double tangent = 0.0;  // infinite where the places are above each other; 0: not more than was asked
  glm::dvec3 high{0.0}, low{0.0};
};

/// `ranges`: one a point of the mesh. The greatest slope that two of them ask for, divided by the way between
/// them (Dinkelbach 1967), if that is more than `slope`, a tangent over 0.
[[nodiscard]] ForcedSlope forced_slope(const PlaneMesh& mesh, const std::vector<HeightRange>& ranges,
                                       double slope);

struct SlopeWish {
  double slope = 1.7320508;  // the most, a tangent
  double narrow = 1e-5;      // narrower facets may be steeper
  bool forced = false;       // some surface has to be steeper: forced_slope()
};
/// Moves the heights, one a point, as little as brings every facet outside down to the slope; within their
/// ranges where that goes.
void keep_slope(const PlaneMesh& mesh, const std::vector<HeightRange>& ranges, const SlopeWish& wish,
                std::vector<double>& z);

}  // namespace moldlight
