// Criteria on what changed, for a script: "undercut > +1%, actions > 0".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moldlight {

/// A figure before and after. Areas and volumes may be given as a share of the part's.
struct ComparedFigure {
  std::string_view name;
  double before = 0.0, after = 0.0;
  double error = 0.0;  // how far their difference may be off
  double whole = 0.0;  // what per cent without a sign are of; 0: it has none
};

/// A figure whose value is the state of a verdict: its number in k_verdict_states.
inline constexpr std::string_view k_verdict_figure = "verdict";
/// None for what is no state.
[[nodiscard]] std::optional<double> verdict_number(std::string_view state);

/// A value of the figure for people; of a verdict the state.
[[nodiscard]] std::string value_text(const ComparedFigure& figure, double value);
/// "+1.5"; of a verdict "worse" or "better"; empty where nothing changed.
[[nodiscard]] std::string change_text(const ComparedFigure& figure);

/// "+2.01 %" of what it was; empty where that was nothing, and where two decimals show no change.
[[nodiscard]] std::string change_percent(double before, double after);

/// NAME > VALUE or NAME >= VALUE. A value with a sign is that of the change, in the figure's own unit or in
/// per cent of what it was before; one without is that of the figure now, in its unit or in per cent of the
/// part's. The value of `verdict` is a state, which is greater the worse it is.
struct Criterion {
  std::string text;  // as given
  std::string name;
  bool or_equal = false, of_change = false, per_cent = false;
  double value = 0.0;

  /// What is to fail. A change within its error is none; any growth from 0 is more than every share of it.
  [[nodiscard]] bool is_met_by(const ComparedFigure& figure) const;
};

/// Of a list with commas; `names` are those that there are. Throws UsageError in one line.
[[nodiscard]] std::vector<Criterion> parse_criteria(std::string_view text,
                                                    std::span<const std::string_view> names);

/// A sentence for each that is met. Throws UsageError for a figure that is not among them, such as the volume
/// of a part that is not closed, and for per cent of what has no whole.
[[nodiscard]] std::vector<std::string> met_criteria(std::span<const Criterion> criteria,
                                                    std::span<const ComparedFigure> figures);

/// A line a figure that changed by more than its error; that nothing did, where that is so.
[[nodiscard]] std::string figure_changes_table(std::span<const ComparedFigure> figures);

}  // namespace moldlight
