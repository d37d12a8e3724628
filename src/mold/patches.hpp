// Undercut patches of whole facets, as far as facets go: what an overlap of bodies may put in doubt
// together.
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// Facets of which at least half is undercut, or as much as a 1000th of the part's area (of a coarse mesh's
/// large facets), connected across shared edges. Patches of less than a 100,000th of the part's area are left
/// out.
struct UndercutPatches {
  std::size_t count = 0;
  std::vector<FacetIndex> of_facet;  // patch number, largest patch first; k_no_facet outside
  std::vector<double> areas;         // undercut area of each patch, model units squared
};
[[nodiscard]] UndercutPatches undercut_patches(const FacetFractions& facet_fractions,
                                               const FacetGeometry& geometry, const Adjacency& adjacency);

}  // namespace moldlight
