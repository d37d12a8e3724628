// The figures that criteria and baselines compare: one table of those of two parts, one of those in a report.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "classify/figure_table.hpp"
#include "classify/json.hpp"
#include "compare/comparison.hpp"
#include "compare/criteria.hpp"

namespace moldlight {

/// What each part's surface measures: JSON has these below "/regions/a" and "/regions/b", and what they
/// differ by, but for errors, below "/regions/difference".
[[nodiscard]] std::span<const FigureRow<ComparedPart>> region_figures();

/// Names of all figures of a comparison, whether or not these parts have them.
[[nodiscard]] std::vector<std::string_view> comparison_figure_names();
/// Those that both parts have. What only the difference has, such as new surface, was 0 before.
[[nodiscard]] std::vector<ComparedFigure> comparison_figures(const Comparison& comparison);

/// Names of the figures that a report of a command (`classify`, `sweep`, `actions`, `mold`) can have.
[[nodiscard]] std::vector<std::string_view> report_figure_names(std::string_view command);
/// Those of two reports of one command, as its --json writes them; of a sweep those of its best direction.
/// Throws UsageError, which names `file`, where `before` is no such report.
[[nodiscard]] std::vector<ComparedFigure> report_figures(std::string_view command, const Json& before,
                                                         const Json& after, std::string_view file);

}  // namespace moldlight
