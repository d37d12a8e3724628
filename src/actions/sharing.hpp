// Undercuts that one slide or lifter forms together.
#pragma once

#include <span>
#include <vector>

#include "actions/undercut_part.hpp"

namespace moldlight {

/// How near undercuts must be to share a slide; shares of the part's diagonal.
struct SharingReach {
  double across = 0.0, along = 0.0;  // its direction
};

/// Of each pull of each undercut part: the undercut part alone and, for slides, all that its direction
/// releases as well and that are near it or near another one of them; if some of their own directions are
/// within k_bundle_deg, the shapes of both suggest the same one, or it is an axis of the part and both are
/// free to turn to it. None behind another is reached over a gap of more than twice their lengths. A lifter
/// is for those beside it, too, over gaps no wider than they are, if it clears all with little more travel.
[[nodiscard]] std::vector<ActionOption> pull_options(const std::vector<UndercutPart>& undercut_parts,
                                                     const PullFinder& pulls, const SharingReach& reach);
/// Likewise of further pulls of one of them.
[[nodiscard]] std::vector<ActionOption> pull_options(const std::vector<UndercutPart>& undercut_parts,
                                                     const PullFinder& pulls, const SharingReach& reach,
                                                     std::size_t undercut_part,
                                                     std::span<const Pull> further);

}  // namespace moldlight
