// Criteria on a batch, and what is new, gone and changed since the table of an earlier one.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "batch/merge.hpp"
#include "cli/gate.hpp"

namespace moldlight::cli {

/// Names of what criteria may ask of a batch: figures of each part, and counts of parts.
[[nodiscard]] std::vector<std::string_view> batch_figure_names();

/// Takes the rows of a merge. A part is known by its path and its settings, or by its path where the table
/// has it once. What is missing in either is not compared; an area that differs by less than 1e-8 of the
/// surface is the same. Criteria on what a figure is now are tried on new parts, too.
class BatchBaseline : public batch::MergeSink {
 public:
  /// Reads the table of `merge --csv`, if one is named. Throws FileError for what is none, and UsageError for
  /// criteria on a change where there is no table. `gate` outlives this.
  BatchBaseline(std::string file, const Gate& gate);

  void add(const batch::PartResult& result) override;
  /// Throws UsageError for a criterion on a figure that no part has in both.
  void finish() override;

  /// How many parts are new, gone and changed, and the first changes; empty without an earlier table.
  [[nodiscard]] std::string table() const;
  /// A sentence for each criterion that a part meets, the first of them; and how many there are.
  [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }
  [[nodiscard]] std::size_t failure_count() const { return failure_count_; }
  /// What --junit asks for: every criterion on every part that has its figure, then those on the whole batch.
  [[nodiscard]] const std::vector<GateCase>& cases() const { return cases_; }

 private:
  struct Row {
    std::string path, settings, state, unit, verdict;
    std::array<std::optional<double>, batch::k_figure_count> figures;
    bool found = false;
  };
  struct Columns;
  [[nodiscard]] Row row_of(const Columns& columns, const std::vector<std::string>& fields,
                           std::size_t line) const;
  [[nodiscard]] Row* earlier(const batch::PartResult& result);
  void compare(const batch::PartResult& result, const Row& before);
  /// Tries the criteria that need nothing earlier.
  void apply_alone(const batch::PartResult& result);
  void note(const std::string& path, std::string_view what, const std::string& was, const std::string& is);
  /// Tries the criteria that ask for one of the figures, those on a change where there is an earlier one;
  /// `path` is empty for counts of parts.
  void apply(std::string_view path, std::span<const ComparedFigure> figures, bool has_earlier = true);

  std::string file_;
  const Gate& gate_;
  std::vector<bool> applied_;  // of the criteria
  std::vector<Row> rows_;
  std::unordered_map<std::string, std::vector<std::size_t>> rows_of_path_;
  std::size_t fresh_ = 0, gone_ = 0, changed_ = 0, same_ = 0, failed_before_ = 0, failed_ = 0, noted_ = 0;
  std::string changes_;
  std::vector<std::string> failures_;
  std::vector<GateCase> cases_;
  std::size_t failure_count_ = 0;
};

}  // namespace moldlight::cli
