// A report as a PDF for paper: the content of the page that html_writer makes, with the picture in place of
// the view that turns.
#pragma once

#include <cstdint>
#include <string>

#include "report/report.hpp"

namespace moldlight::report {

enum class Paper : std::uint8_t { a4, letter };

/// The document; the same bytes for the same report and fonts.
[[nodiscard]] std::string pdf_document(const Report& report, Paper paper);

/// Replaces the file whole or not at all; throws FileError.
void write_pdf(const std::string& path, const Report& report, Paper paper);

}  // namespace moldlight::report
