// An order of a part's facets by where they lie, so that what is found does not depend on how the file lists
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Puts the vertices, and the facets of each body, in an order along a curve through the part's box (Morton
/// 1966, 2,097,152 steps an axis), and turns each facet so that its first corner is the first of them. Parts
/// that differ only in the order of facets, vertices and corners become the same, but for file_facets, which
/// has each facet's number in the file. Throws Cancelled.
void put_in_place_order(Part& part, const Progress& progress);

/// The part's facets as the file lists them: body by body, those that a repair added after the others.
[[nodiscard]] std::vector<FacetIndex> listed_facets(const Part& part);

/// The facet's number in the file; -1 for one that a repair added.
[[nodiscard]] std::int64_t file_facet(const Part& part, FacetIndex facet);

}  // namespace moldlight
