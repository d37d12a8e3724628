// A table on the pages of a document: its columns as wide as what they hold, as far as there is room.
#pragma once

#include <vector>

#include "report/pdf/flow.hpp"
#include "report/report.hpp"

namespace moldlight::report {

/// Rows with their headings, which stand above the first row of every page. `canvas` measures; the pieces
/// keep pointers into the table.
[[nodiscard]] std::vector<Piece> table_pieces(Canvas& canvas, const Table& table, double width_pt);

}  // namespace moldlight::report
