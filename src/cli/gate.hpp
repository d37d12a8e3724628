// What a script's run is gated by: --fail-on, and --junit for its outcome.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "compare/criteria.hpp"

namespace moldlight::cli {

struct Gate {
  std::vector<Criterion> criteria;
  std::string junit;  // file for the outcome; empty: none
};

/// --fail-on for these figures, and --junit. The option of the first.
CLI::Option* add_gate_flags(CLI::App& command, Gate& gate, const std::vector<std::string_view>& figures);

/// Throws UsageError for a criterion on a change: there is nothing earlier.
void require_no_change(std::span<const Criterion> criteria);

/// A criterion tried on a part.
struct GateCase {
  std::string part, criterion;
  std::string failure = {};  // the sentence of met_criteria(); empty: it holds back nothing
};
/// A case for each criterion. Throws as met_criteria().
[[nodiscard]] std::vector<GateCase> gate_cases(std::string_view part, std::span<const Criterion> criteria,
                                               std::span<const ComparedFigure> figures);

/// Writes what --junit asks for: XML in the form of JUnit, a suite a part and a test a criterion, which build
/// servers show. Throws FileError.
void write_junit(const Gate& gate, std::span<const GateCase> cases);
/// Writes that, and says which cases failed: the exit code, or 0. Throws FileError.
[[nodiscard]] int gate_outcome(const Gate& gate, std::span<const GateCase> cases, Console& console);

}  // namespace moldlight::cli
