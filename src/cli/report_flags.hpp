// The flags of the reports that people send, the same in every command that has them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "report/describe/describe.hpp"
#include "report/pdf_writer.hpp"
#include "report/text_writer.hpp"

namespace moldlight::cli {

struct ReportFlags {
  std::string html, pdf;
  report::Paper paper = report::Paper::a4;
  const Request* request = nullptr;  // that has the command line

  [[nodiscard]] bool any() const { return !html.empty() || !pdf.empty(); }
  /// As check_outputs() takes them.
  [[nodiscard]] std::vector<NamedPath> files() const { return {{"--html", html}, {"--pdf", pdf}}; }
};

/// Adds --html, --pdf and --paper. `request` and `flags` outlive the command.
void add_report_flags(CLI::App& command, ReportFlags& flags, const Request& request);

/// What a report is made with; `context` and `progress` must outlive it.
[[nodiscard]] report::ReportContext report_context(const ReportFlags& flags, const gl::Context& context,
                                                   std::shared_ptr<const PartModel> model, Palette palette,
                                                   const Progress& progress);

/// Writes what the flags ask for. Throws FileError.
void write_reports(const ReportFlags& flags, const report::Report& report);

/// Words as a shell takes them.
[[nodiscard]] std::string command_text(const std::vector<std::string>& words);

}  // namespace moldlight::cli
