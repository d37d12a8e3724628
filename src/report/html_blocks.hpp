// The blocks of a report as HTML.
#pragma once

#include <string>

#include "report/report.hpp"

namespace moldlight::report {

/// A square in the mark's colour, with stripes where it is hatched.
[[nodiscard]] std::string mark_html(const Mark& mark);
[[nodiscard]] std::string picture_html(const Picture& picture);
[[nodiscard]] std::string block_html(const Block& block);

}  // namespace moldlight::report
