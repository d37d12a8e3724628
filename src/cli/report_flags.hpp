// The flags of the reports that people send, and of the earlier report that a run is compared with: the same
// in every command that has them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/flags.hpp"
#include "compare/criteria.hpp"
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

struct BaselineFlags {
  std::string file;  // empty: none
  std::vector<Criterion> fail_on;
};
/// Adds both, the second for figures of reports of this command (`classify`, `sweep`, `actions`, `mold`).
void add_baseline_flags(CLI::App& command, BaselineFlags& flags, std::string_view name);

/// An earlier report, and what has changed since.
class Baseline {
 public:
  /// Reads the report, if one is named. Throws FileError.
  Baseline(const BaselineFlags& flags, std::string command);

  /// Compares, where there is a baseline or a criterion. Throws UsageError for a report of something else,
  /// for criteria on figures that the reports do not have, and for those of a change without a baseline.
  void compare(const std::function<nlohmann::ordered_json()>& report);

  /// Puts out the report as --json asks for it, with `baseline` in JSON (its file, the figures before and
  /// after) and a table of what changed below the text, where there is one.
  void put_report(Console& console, const std::string& json_path,
                  const std::function<nlohmann::ordered_json()>& json,
                  const std::function<std::string()>& text) const;
  /// Says which criteria failed: the exit code, or 0.
  [[nodiscard]] int exit_code(Console& console) const;

 private:
  [[nodiscard]] std::string table() const;
  void add_to(nlohmann::ordered_json& report) const;

  const BaselineFlags& flags_;
  std::string command_;
  nlohmann::ordered_json before_;
  std::vector<ComparedFigure> figures_;
  std::vector<std::string> failed_;
};

}  // namespace moldlight::cli
