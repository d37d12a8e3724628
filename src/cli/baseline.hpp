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
/// Adds both, the second for figures of reports of this command (`classify`, `sweep`).
void add_baseline_flags(CLI::App& command, BaselineFlags& flags, std::string_view name);

/// An earlier report, and what has changed since.
class Baseline {
 public:
  /// Reads the report, if one is named. Throws FileError.
  Baseline(const BaselineFlags& flags, std::string command);

  /// Compares. Throws UsageError for a report of something else, and for criteria on figures that the reports
  /// do not have.
  void compare(const std::function<nlohmann::ordered_json()>& report);

  /// For the report's table; empty without a baseline.
  [[nodiscard]] std::string table() const;
  /// Adds `baseline` to the report: its file, and the figures before and after.
  void add_to(nlohmann::ordered_json& report) const;
  /// Says which criteria failed: the exit code, or 0.
  [[nodiscard]] int exit_code(Console& console) const;

 private:
  const BaselineFlags& flags_;
  std::string command_;
  nlohmann::ordered_json before_;
  std::vector<ComparedFigure> figures_;
  std::vector<std::string> failed_;
};

}  // namespace moldlight::cli
