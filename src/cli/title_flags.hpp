// The flags of a report's title block: who sends it, and of what.
#pragma once

#include <CLI/CLI.hpp>

#include "report/report.hpp"

namespace moldlight::cli {

/// Adds --revision, --material, --company, --author, --logo, --date and --note. `title` outlives the command.
void add_title_flags(CLI::App& command, report::TitleFacts& title);

/// The day that the environment asks for, "2026-11-25" (SOURCE_DATE_EPOCH, in seconds); empty where it asks
/// for none.
[[nodiscard]] std::string day_of_environment();

}  // namespace moldlight::cli
