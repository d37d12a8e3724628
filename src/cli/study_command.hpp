// Common parts of `classify`, `actions` and `mold`: a part, one direction, how it is classified, a
// picture, and the report with its baseline.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

struct StudyFlags {
  std::string command;
  PartFlags part;
  Query query;
  bool best_direction = false;
  BaselineFlags baseline;
  ReportFlags report;
  std::string image;
  StillSettings still;

  [[nodiscard]] bool drawn() const { return !image.empty() || report.any(); }
};

/// Adds PART and the direction to the command, whose name the flags keep.
void add_study_flags(CLI::App& command, StudyFlags& flags, Request& request);
/// Adds --baseline, --fail-on, --html, --pdf, --image (of what `image_help` says) and --size. The flag of the
/// picture.
CLI::Option* add_report_flags(CLI::App& command, StudyFlags& flags, const Request& request,
                              const std::string& image_help);

/// Refuses outputs that would overwrite an input or each other: these, and those of the common flags.
void check_outputs(const StudyFlags& flags, const std::vector<NamedPath>& files, const NamedPath& folder);

/// The part as it was read, with the direction that is asked about.
struct AskedPart {
  std::shared_ptr<const PartModel> model;
  Questions questions;  // its query, and how a best direction was found
};
/// Reads it, and finds the best direction where that is asked for. Throws as load_part() and validate().
[[nodiscard]] AskedPart asked_part(const StudyFlags& flags, Console& console, const Progress& progress);

/// The study's report, for programs and for people.
struct StudyReport {
  nlohmann::ordered_json (*json)(Study&, const Progress&);
  report::Report (*people)(const report::ReportContext&, Study&);
  std::function<void(nlohmann::ordered_json&)> add = {};  // to what is for programs
};
/// Compares it with the baseline and puts it out wherever the flags ask for it; `context` is needed for those
/// that are drawn. The exit code of the criteria.
[[nodiscard]] int put_report(const StudyFlags& flags, Study& study, const StudyReport& report,
                             const gl::Context* context, Baseline& baseline, Console& console,
                             const Progress& progress);

/// Direction, method and reading as Request::settings gives them.
[[nodiscard]] nlohmann::ordered_json study_settings(const StudyFlags& flags);

}  // namespace moldlight::cli
