// The flags of the reports that people send, and of the earlier report that a run is compared with: the same
// in every command that has them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "classify/json.hpp"
#include "cli/command.hpp"
#include "cli/flags.hpp"
#include "cli/gate.hpp"
#include "report/describe/describe.hpp"
#include "report/page_options.hpp"
#include "report/writers.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

struct ReportFlags {
  std::string html, pdf;
  bool live = false;
  report::PaperSettings paper;
  report::TitleFacts title;
  const Request* request = nullptr;  // that has the command line

  [[nodiscard]] bool any() const { return !html.empty() || !pdf.empty(); }
  /// As check_outputs() takes them.
  [[nodiscard]] std::vector<NamedPath> files() const { return {{"--html", html}, {"--pdf", pdf}}; }
};

/// Adds --html, --pdf, --paper, and --revision, --material and the others of the title block. `request` and
/// `flags` outlive the command.
void add_report_flags(CLI::App& command, ReportFlags& flags, const Request& request);

/// Adds --live, which needs --html.
void add_live_flag(CLI::App& command, ReportFlags& flags);

/// What a report is made with; `context` and `progress` must outlive it.
[[nodiscard]] report::ReportContext report_context(const ReportFlags& flags, const gl::Context& context,
                                                   std::shared_ptr<const PartModel> model, Palette palette,
                                                   const Progress& progress);

/// Writes what the flags ask for, and warns where a page could not be made live. Throws FileError.
void write_reports(const ReportFlags& flags, const report::Report& report, Console& console);

struct BaselineFlags {
  std::string file;  // empty: none
  Gate gate;
};
/// Adds --baseline, and the gate for figures of reports of this command; nothing for one whose report has
/// none.
void add_baseline_flags(CLI::App& command, BaselineFlags& flags, std::string_view name);

/// An earlier report, and what has changed since.
class Baseline {
 public:
  /// Reads the report, if one is named; `part` is the path of the part. Throws FileError.
  Baseline(const BaselineFlags& flags, std::string command, const std::string& part);

  /// Compares, where there is a baseline or a criterion. Throws UsageError for a report of something else,
  /// for criteria on figures that the reports do not have, and for those of a change without a baseline.
  void compare(const std::function<Json()>& report);

  /// Puts out the report as --json asks for it, with `baseline` in JSON (its file, the figures before and
  /// after) and a table of what changed below the text, where there is one.
  void put_report(Console& console, const std::string& json_path, const std::function<Json()>& json,
                  const std::function<std::string()>& text) const;
  /// Says which criteria failed, and writes what --junit asks for: the exit code, or 0.
  [[nodiscard]] int exit_code(Console& console) const;

 private:
  [[nodiscard]] std::string table() const;
  void add_to(Json& report) const;

  const BaselineFlags& flags_;
  std::string command_, part_;
  Json before_;
  std::vector<ComparedFigure> figures_;
  std::vector<GateCase> cases_;
};

struct StudyFlags {
  std::string command;
  PartFlags part;
  Query query;
  bool best_direction = false;
  BaselineFlags baseline;
  ReportFlags report;
  std::string image;
  std::string step;  // the part's own faces
  StillSettings still;

  [[nodiscard]] bool drawn() const { return !image.empty() || report.any(); }
};

/// Adds PART and the direction to the command, whose name the flags keep.
void add_study_flags(CLI::App& command, StudyFlags& flags, Request& request);
/// Adds --baseline, --fail-on, --html, --pdf, --image (of what `image_help` says) and --size. The flag of the
/// picture.
CLI::Option* add_study_outputs(CLI::App& command, StudyFlags& flags, const Request& request,
                               const std::string& image_help);

/// Refuses outputs that would overwrite an input or each other: these, and those of the common flags.
void check_outputs(const StudyFlags& flags, const std::vector<NamedPath>& files, const NamedPath& folder);

/// Reads the part, and finds the best direction where that is asked for; `questions` are what the flags do
/// not ask. Throws as load_part() and validate().
[[nodiscard]] Study asked_study(const StudyFlags& flags, Questions questions, Console& console,
                                const Progress& progress);

/// The study's report, for programs and for people.
struct StudyReport {
  Json (*json)(Study&, const Progress&);
  report::Report (*people)(const report::ReportContext&, Study&);
  std::function<void(Json&)> add = {};  // to what is for programs
  Json step = {};                       // of --step, likewise; null without it
};
/// Compares it with the baseline and puts it out wherever the flags ask for it; `context` is needed for those
/// that are drawn. The exit code of the criteria.
[[nodiscard]] int put_report(const StudyFlags& flags, Study& study, const StudyReport& report,
                             const gl::Context* context, Baseline& baseline, Console& console,
                             const Progress& progress);

/// Direction, method and reading as Request::settings gives them.
[[nodiscard]] Json study_settings(const StudyFlags& flags);

}  // namespace moldlight::cli
