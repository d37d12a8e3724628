// The parting line in one plane, where the part's outer walls can carry it there.
#pragma once

#include "parting/loops.hpp"

namespace moldlight {

/// Which half forms what, and the line where they meet.
struct MoldLine {
  Assignment assignment;
  PartingLine line;
};

/// Along edges of the part's facets, as assign_sides() has it; or where the outer walls that are free are
/// divided at one height, if that costs less, or is planar and costs more by no more than the settings'
/// `planar_worth_pct`. Throws what assign_sides() does.
[[nodiscard]] MoldLine find_mold_line(const PartModel& model, const Query& query,
                                      const MoldSettings& settings, const Progress& progress);

}  // namespace moldlight
