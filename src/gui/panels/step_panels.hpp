// The steps of the strip along the top, and their panels: one is open at a time.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gui/draw/sorted_table.hpp"
#include "gui/panels/panels.hpp"
#include "gui/panels/table_bar.hpp"
#include "sweep/direction_figures.hpp"

namespace moldlight::gui {

/// Size of the picture in a candidate's tooltip, pixels; `scale`: pixels per layout unit.
[[nodiscard]] glm::ivec2 candidate_picture_size(float scale);

/// The order of the table's rows: by a figure, or by rank.
[[nodiscard]] std::vector<std::size_t> sorted_candidates(const SweepResult& result, const DirectionFigure* by,
                                                         bool descending);

/// The search for directions: in its step's panel how far it is and cards of what it recommends; along the
/// bottom, where it is asked for, its options or the directions as a table to sort and click.
class SweepPanel {
 public:
  /// `pictures`: a texture a candidate of the result; 0, or too few of them, where there is none yet.
  void draw(const PanelContext& context, std::span<const unsigned> pictures);
  void draw_below(const PanelContext& context, std::span<const unsigned> pictures);

 private:
  void draw_table(const PanelContext& context, std::span<const unsigned> pictures);
  using Figures = std::vector<const DirectionFigure*>;
  void draw_row(const PanelContext& context, const Figures& figures, std::size_t place,
                std::span<const unsigned> pictures);
  void draw_footer(const PanelContext& context);

  std::shared_ptr<const SweepResult> result_;  // of the rows; kept, so that no later one has its address
  std::shared_ptr<const SweepResult> seen_;    // the last one
  SortedTable table_{"#", false};              // of candidates
  enum class Below : std::uint8_t { nothing, table, options } below_ = Below::nothing;
};

/// What the table of bodies is sorted by, and the words that it is filtered by.
struct BodyOrder {
  enum class By : std::uint8_t { name, verdict, undercut, unreleased, facets } by = By::undercut;
  bool descending = true;
  std::string words = {};
};
/// Numbers of the bodies that pass, in order; those without a verdict come last.
[[nodiscard]] std::vector<std::size_t> sorted_bodies(const BodiesState& bodies, const BodyOrder& order);

/// The bodies of the file: in the step's panel a tree; along the bottom, where it is asked for, the verdict
/// on each as a table.
class BodiesPanel {
 public:
  /// `pictures`: of each body.
  void draw(const PanelContext& context, const PictureOf& pictures);
  void draw_below(const PanelContext& context, const PictureOf& pictures);

 private:
  void draw_row(const PanelContext& context, const PictureOf& pictures, std::size_t place);

  RowCursor tree_;
  bool table_shown_ = false;
  SortedTable table_{"undercut", true};
  std::ptrdiff_t known_ = 0;  // verdicts, by which the rows are in order
};

/// The draft: how much surface has how much of it, and the walls that have too little, with what turning
/// them would cost.
class DraftPanel {
 public:
  void draw(const PanelContext& context);

 private:
  [[nodiscard]] BarNews news(const AppState& state) const;
  void draw_finishes(const PanelContext& context);
  void draw_walls(const PanelContext& context, RowCursor& cursor) const;
  void draw_row(const PanelContext& context, std::size_t wall, bool marked) const;

  [[nodiscard]] const DraftCheck* check() const { return line_ && line_->draft ? &*line_->draft : nullptr; }

  // The last one of the part; kept, so that the chart stays while its limit is dragged.
  std::shared_ptr<const MoldLine> line_;
  std::shared_ptr<const PartModel> model_;
  TableBar bar_;
  RowCursor finish_cursor_;
};

/// What is written of the part: pictures, files and the report.
class ReportPanel {
 public:
  void draw(const PanelContext& context);

 private:
  void draw_report(const PanelContext& context, float width);

  report::ReportOrder order_;
  std::string proposed_;  // name, beside the part
  std::array<char, 1024> path_{};
};

/// The chart's, as it is drawn: from which to which draft, and the areas' ends in it.
struct DraftChart {
  static constexpr double k_from_deg = -5.0, k_to_deg = 10.0;
  ScreenBox box;

  /// Pixels from the window's left.
  [[nodiscard]] float place_of(double draft_deg) const {
    const double share = (draft_deg - k_from_deg) / (k_to_deg - k_from_deg);
    return box.min.x + static_cast<float>(share) * (box.max.x - box.min.x);
  }
  /// The draft at a place, within the chart.
  [[nodiscard]] double draft_at(float x) const {
    const double share = std::clamp((x - box.min.x) / (box.max.x - box.min.x), 0.0F, 1.0F);
    return k_from_deg + share * (k_to_deg - k_from_deg);
  }
};

/// What the strip says of a step: nothing, a tick, how many, or that something is to be looked at.
struct StepBadge {
  enum class Kind : std::uint8_t { none, tick, count, warning } kind = Kind::none;
  std::string count = {};  // beside a warning, too
  std::string help = {};   // what it means, a sentence
};

class StepPanels;

/// What steps have pictures of.
struct StepPictures {
  std::span<const unsigned> candidates;  // the sweep's directions
  PictureOf bodies;                      // of the file
};

struct StepRow {
  Step step;
  std::string_view title;
  std::string_view help;  // what it is for
  StepBadge (*badge)(const AppState& state);
  void (*panel)(StepPanels& panels, const PanelContext& context, const StepPictures& pictures);
};
/// In the order of the strip.
[[nodiscard]] const std::array<StepRow, 7>& step_rows();
/// As the strip shows it: no tick while there is red in the picture.
[[nodiscard]] StepBadge step_badge(const AppState& state, const StepRow& row);

/// The panel on the left, with the controls of the step that is open.
class StepPanels {
 public:
  void draw(const PanelContext& context, const StepPictures& pictures);
  /// What the step has along the bottom.
  void draw_below(const PanelContext& context, const StepPictures& pictures);
  void give_up_drag() { ball.active = false; }

  BodiesPanel bodies;
  BallDrag ball;
  SweepPanel sweep;
  TableBar actions, line, mold;
  DraftPanel draft;
  ReportPanel report;
};

}  // namespace moldlight::gui
