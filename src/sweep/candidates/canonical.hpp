// Canonical directions: those that the shape of a part names, and that a mold maker tries first.
#pragma once

#include <vector>

#include "classify/part_model.hpp"
#include "sweep/candidates/candidate.hpp"

namespace moldlight {

/// The file's axes; normals of planes and axes of round walls, put together within a tenth of a degree, the
/// largest first, as far as they are a hundredth of the surface; principal axes where there are none. At most
/// twelve. Of two within 3 degrees the one for which more of the surface speaks is canonical. Axes of the
/// file for which none does are among them, but not canonical where the part is turned. All others turn with
/// the part and do not depend on the order of its facets.
[[nodiscard]] std::vector<Candidate> canonical_candidates(const PartModel& model);

}  // namespace moldlight
