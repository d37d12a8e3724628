// Columns put on segments of the plane, wherever sheets end over them.
#pragma once

#include <vector>

#include "parting/hull/sheets.hpp"

namespace moldlight {

struct SegmentCut {
  Column a = 0, b = 0;  // of the segment
  Column at = 0;
};
/// Every end of a sheet over these segments gets vertices in the columns.
void cut_segments(Sheets& sheets, const std::vector<SegmentCut>& cuts);

}  // namespace moldlight
