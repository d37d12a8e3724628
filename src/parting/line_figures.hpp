// Length and climb of a direction's parting line, as a sweep compares them.
#pragma once

#include "parting/loops.hpp"

namespace moldlight {

/// In the part's unit; of outer loops and shut-offs. The climbs of the loops are summed up.
struct LineFigures {
  double length = 0.0, climb = 0.0;
  double outer_climb = 0.0;   // from the lowest point of the outer loops to their highest
  double steep_length = 0.0;  // of the runs that climb by more than 64 degrees
};

[[nodiscard]] LineFigures line_figures(const PartingLine& line);

}  // namespace moldlight
