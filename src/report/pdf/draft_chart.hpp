// The histogram of areas by draft on the pages of a document.
#pragma once

#include "report/pdf/flow.hpp"
#include "report/report.hpp"

namespace moldlight::report {

/// `bars` must not be empty; the piece keeps a pointer to it.
[[nodiscard]] Piece draft_chart_piece(const DraftBars& bars, double width_pt);

}  // namespace moldlight::report
