// A report as text for a terminal.
#pragma once

#include <string>

#include "report/report.hpp"

namespace moldlight::report {

struct TextStyle {
  bool colour = false;  // names in the colours of what they name
  bool wide = false;    // with the columns that few terminals have room for
};

/// The sentence and what else the verdict says, then the sections that a terminal gets: no pictures, tables
/// of a screen's length.
[[nodiscard]] std::string to_text(const Report& report, const TextStyle& style);

}  // namespace moldlight::report
