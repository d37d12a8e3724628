// Length and climb of a direction's parting line, as a sweep compares them.
#pragma once

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "classify/settings.hpp"

namespace moldlight {

/// In the part's unit; of outer loops and shut-offs. The climbs of the loops are summed up.
struct LineFigures {
  double length = 0.0, climb = 0.0;
  double outer_climb = 0.0;   // from the lowest point of the outer loops to their highest
  double steep_length = 0.0;  // of the runs that climb by more than 64 degrees
};

/// Of the parting line with default settings. Throws Cancelled.
[[nodiscard]] LineFigures line_figures(const PartModel& model, const Query& query, const Progress& progress);

}  // namespace moldlight
