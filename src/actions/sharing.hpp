// Undercuts that one slide, or one lifter, forms together.
#pragma once

#include <vector>

#include "actions/atom.hpp"

namespace moldlight {

/// How near undercuts must be to share a slide, and a lifter; shares of the part's diagonal.
struct SharingReach {
  double across = 0.0, along = 0.0;  // the slide's direction
  double stem = 0.0;                 // of a lifter: what it is carried by is so wide
};

/// Adds, for a pull of an atom, the atom alone and, for slides, all that its direction releases as well and
/// that are near it or near another one of them; if some of their own directions are within k_bundle_deg, or
/// the shapes of both suggest the same one. None behind another is reached over a gap of more than twice
/// their lengths. For lifters those that stand on one stem.
void add_pull_columns(const std::vector<Atom>& atoms, const PullFinder& pulls, const SharingReach& reach,
                      std::size_t atom, const Pull& pull, std::vector<Column>& columns);
/// Of each pull of each atom.
[[nodiscard]] std::vector<Column> pull_columns(const std::vector<Atom>& atoms, const PullFinder& pulls,
                                               const SharingReach& reach);

}  // namespace moldlight
