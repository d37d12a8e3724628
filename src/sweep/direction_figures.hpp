// The one table of a direction's figures, from which JSON, the terminal's and the window's table, pictures
// and objectives are all made.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "classify/figure_table.hpp"
#include "classify/part_model.hpp"
#include "parting/line_figures.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// What the figures of one direction are found from.
struct DirectionFacts {
  const PartModel& model;
  const SweepSettings& settings;
  const Classification& classification;  // what classify gives; before that what the score knows
  double draw_depth = 0.0;
  bool measured = false;                      // not by its score alone
  std::optional<std::size_t> undercuts = {};  // how many undercuts
  std::optional<TiltMargin> tilt = {};
  std::optional<LineFigures> parting = {};
  const DirectionActions* actions = nullptr;  // once they are found
};

struct DirectionFigure {
  std::string_view key;    // in JSON
  std::string_view label;  // heads its column, wherever it is shown
  FigureKind kind = FigureKind::area;
  std::string_view help;
  struct Use {
    bool objective = false;   // can be ranked by, under its key with - for _; less is better
    bool classified = false;  // JSON has it among what classify shows
    bool column = true;       // has a column in tables even where nothing is ranked by it
    bool brief = false;       // in narrow ones, too
    bool yields = false;      // but not beside side actions
    bool of_actions = false;  // found from side actions
  } use;
  std::optional<double> (*find)(const DirectionFacts& facts);  // none where it is not known
  std::string_view former = {};  // key that JSON has beside the key until the schema's number rises
};

[[nodiscard]] std::span<const DirectionFigure> direction_figures();
/// The row of this key, which the table must hold.
[[nodiscard]] const DirectionFigure& direction_figure(std::string_view key);
/// All of them, in the table's order.
[[nodiscard]] std::vector<std::optional<double>> find_figures(const DirectionFacts& facts);

/// The candidate's figure; none where it is not known.
[[nodiscard]] std::optional<double> figure_value(const DirectionFigure& figure,
                                                 const SweepCandidate& candidate);
/// The same for people, without its unit: "≈ 12.3" for an area that is only scored, "> 30°", "-" where it
/// is not known.
[[nodiscard]] std::string figure_text(const DirectionFigure& figure, const PartModel& model,
                                      const SweepCandidate& candidate);
/// What a table with room for it adds: " to +x-z", the side to which a pull may lean least.
[[nodiscard]] std::string figure_aside(const DirectionFigure& figure, const SweepCandidate& candidate);
/// "depth mm".
[[nodiscard]] std::string figure_heading(const DirectionFigure& figure, const PartModel& model);
/// The figures that have a column, or that the result is ranked by, and that are known of some candidate.
[[nodiscard]] std::vector<const DirectionFigure*> figure_columns(const SweepResult& result);

/// Leaves those that a narrow table has room for.
void keep_brief(std::vector<const DirectionFigure*>& columns);

/// "undercut", "draw-depth", …: what an objective is written with.
[[nodiscard]] std::vector<std::string_view> objective_names();
/// Whether side actions must be known to show its value.
[[nodiscard]] bool needs_actions(const Objective& objective);
/// Whether a sweep finds side actions, for its objective or because it was asked to.
[[nodiscard]] bool seeks_actions(const SweepSettings& settings);

/// What undercut that nothing releases adds to the weight of the rest: what is more than a 1000th of the
/// part's area makes a direction worse than all that leave less, and a smaller rest weighs more than any one
/// action; beside that every 1000th weighs as a slide does. 0 where side actions are not known.
[[nodiscard]] double unreleased_penalty(const DirectionFacts& facts);

/// A figure that is not known counts as none; one of side actions has the penalty for what is unreleased.
[[nodiscard]] double objective_value(const Objective& objective, const DirectionFacts& facts);

}  // namespace moldlight
