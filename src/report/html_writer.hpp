// A report as one page that opens anywhere without a network: text, pictures, and a view that turns where the
// browser has WebGL 2 and scripts.
#pragma once

#include <string>

#include "report/report.hpp"

namespace moldlight::report {

[[nodiscard]] std::string html_page(const Report& report);

/// Replaces the file whole or not at all; throws FileError.
void write_html(const std::string& path, const Report& report);

}  // namespace moldlight::report
