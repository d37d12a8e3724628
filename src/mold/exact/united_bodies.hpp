// The bodies of a part as one solid: their facets are cut where they cross, and what lies inside material
// goes.
#pragma once

#include <cstddef>

#include "base/progress.hpp"
#include "mesh/repair.hpp"

namespace moldlight {

struct UnionReport {
  std::size_t cut_facets = 0;  // of the part, that others cross
  double inside_area = 0.0;    // the part's unit squared: what went
};

/// Surface whose outer side lies inside material (winding number above 0) or on which another body's surface
/// lies goes, from a part that is closed and wound consistently. What is left is closed once vertices of the
/// cuts are welded, which repair_part() does. Bodies stay, but for those that are inside others. Throws Error
/// where the part is not closed or facets cross too many others, Cancelled.
UnionReport unite_bodies(Part& part, const Progress& progress);

/// What the options ask for: a repair and, if asked for, the union. Throws as these do.
void mend_part(Part& part, const RepairOptions& options, const Progress& progress);

}  // namespace moldlight
