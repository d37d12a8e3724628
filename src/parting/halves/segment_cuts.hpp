// Columns put on segments of the plane, wherever sheets end over them.
#pragma once

#include <vector>

#include "parting/halves/sheets.hpp"

namespace moldlight {

struct SegmentCut {
  PlanePoint a = 0, b = 0;  // of the segment
  PlanePoint at = 0;
};
/// Every end of a sheet over these segments gets vertices in the columns.
void cut_segments(Sheets& sheets, const std::vector<SegmentCut>& cuts);

}  // namespace moldlight
