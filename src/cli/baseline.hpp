// --baseline and --fail-on of a command: its report against an earlier one.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/flags.hpp"
#include "compare/criteria.hpp"

namespace moldlight::cli {

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
