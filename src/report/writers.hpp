// Writers of a report: a page, pages of paper, a terminal's text.
#pragma once

#include <cstdint>
#include <string>

#include "report/report.hpp"

namespace moldlight::report {

/// One page that opens anywhere without a network: text, pictures, and a view that turns where the browser
/// has WebGL 2 and scripts.
[[nodiscard]] std::string html_page(const Report& report);

/// Replaces the file whole or not at all; throws FileError.
void write_html(const std::string& path, const Report& report);

enum class Paper : std::uint8_t { a4, letter };

/// The document; the same bytes for the same report and fonts.
[[nodiscard]] std::string pdf_document(const Report& report, Paper paper);

/// Replaces the file whole or not at all; throws FileError.
void write_pdf(const std::string& path, const Report& report, Paper paper);

struct TerminalStyle {
  bool colour = false;  // names in the colours of what they name
  bool wide = false;    // with the columns that few terminals have room for
};

/// The sentence and what else the verdict says, then the sections that a terminal gets: no pictures, tables
/// of a screen's length.
[[nodiscard]] std::string to_text(const Report& report, const TerminalStyle& style);

}  // namespace moldlight::report
