// Sections that reports of different kinds share: regions, figures, undercuts with pictures, the view, and
// how to repeat it all.
#pragma once

#include <optional>
#include <span>

#include "actions/action_figures.hpp"
#include "classify/json.hpp"
#include "classify/number_format.hpp"
#include "classify/still_picture.hpp"
#include "parting/loops.hpp"
#include "picture/sphere_map.hpp"
#include "report/describe/describe.hpp"

namespace moldlight::report {

/// A value that the JSON report has under `key`.
[[nodiscard]] Value number(std::string text, std::string key, double value);
/// Of a kind of figure, as it is written.
[[nodiscard]] Value number(const FigureStyle& style, FigureKind kind, std::string key, double value);
/// Where the JSON report has what a table lists; none where it has not.
using Place = std::optional<std::string>;
/// Of an entry of a list there.
[[nodiscard]] Place entry_of(const Place& list, std::size_t number);
/// A row's figure, which the JSON report has under `place` and its key.
[[nodiscard]] Value cell(const FigureStyle& style, const FoundFigure& figure, const Place& place);
/// Those that people see, among the details or not among them.
[[nodiscard]] FigureGrid grid_of(const FigureStyle& style, const std::vector<FoundFigure>& figures,
                                 const Place& place, bool details = false);
/// A column for each that has a title, and a row's cells.
template <typename Of>
void add_columns(const FigureStyle& style, std::span<const FigureRow<Of>> rows, Table& table) {
  for (const FigureRow<Of>& row : rows)
    if (!row.title.empty()) table.columns.push_back({style.heading(row.title, row.kind)});
}
void add_cells(const FigureStyle& style, const std::vector<FoundFigure>& figures, const Place& place,
               Row& row);

[[nodiscard]] Mark region_mark(Region region, Palette palette);

/// What a classification has beside its regions.
struct DraftShown {
  const DraftCheck& check;
  bool asked = false;  // for the least draft that it has: else the histogram alone counts
};

/// Sentence and tone of the report, with what else the verdict says below.
void take_verdict(const Verdict& verdict, Report& report);

/// The part of a report that does not depend on what was found.
[[nodiscard]] Report begin_report(const ReportContext& context, std::string kind,
                                  const glm::dvec3& direction);

/// Shares and areas of the regions. `keys`: of the classification; none where the report has not all of it.
[[nodiscard]] Section regions_section(const ReportContext& context, const Classification& result,
                                      const Place& keys);
/// Size and state of the part, with its warnings.
[[nodiscard]] Section part_section(const ReportContext& context, const std::vector<std::string>& warnings);
[[nodiscard]] Section draft_section(const ReportContext& context, const DraftShown& draft);
/// Settings as a JSON report has them, version and command line.
[[nodiscard]] Section repeat_section(const ReportContext& context, const Json& settings);

/// Of pictures without backdrop and legend, which stand on light pages and on dark ones.
[[nodiscard]] StillSettings still_settings(const ReportContext& context, const glm::ivec2& size);

/// Draws still pictures of a classified part, without backdrop, for light pages and dark ones; empty ones
/// for a text.
class Illustrator {
 public:
  Illustrator(const ReportContext& context, const Classification& result);

  /// The part from where its undercuts are seen best, with its scale.
  [[nodiscard]] Image whole(std::vector<StillCallout> callouts, std::span<const StillBody> bodies = {});
  /// And from the other side.
  [[nodiscard]] Image from_behind();
  /// An undercut, the only one in red, from where most of it is seen.
  [[nodiscard]] Image undercut(const Undercut& undercut);
  /// The part with its parting line; and a loop of it, lit, from where most of it is seen.
  [[nodiscard]] Image line(const PartingLine& line, std::vector<StillCallout> callouts);
  [[nodiscard]] Image loop(const PartingLine& line, std::size_t number);
  /// Towards the viewer of whole(), unit; of what is drawn.
  [[nodiscard]] glm::dvec3 to_viewer() const;

 private:
  StillSettings close_up(std::span<const std::uint32_t> pieces, SplitMesh& alone) const;

  const ReportContext* context_;
  const Classification* result_;
  std::optional<StillPainter> painter_;  // none for a text
  glm::dquat seen_from_ = {};
};

/// Numbers of the table's first rows, at surface of their undercuts.
[[nodiscard]] std::vector<StillCallout> undercut_callouts(const SplitMesh& split,
                                                          std::span<const Undercut* const> undercuts);

/// Numbers of these loops, on them.
[[nodiscard]] std::vector<StillCallout> loop_callouts(const PartingLine& line,
                                                      std::span<const std::size_t> loops);

/// A table of undercuts, the largest with a picture each; `totals` has what is too small to be one.
[[nodiscard]] Table undercut_table(const ReportContext& context, Illustrator& pictures,
                                   std::span<const Undercut* const> undercuts, const UndercutTotals& totals,
                                   const Place& keys = {});

/// A row an action.
[[nodiscard]] Table actions_table(const PartModel& model, const ActionPlan& plan, const Place& keys);

/// The solids that the actions move, when they do, and whether they are clear.
[[nodiscard]] Table bodies_table(const PartModel& model, const ActionPlan& plan, const Place& keys);

/// Of the part alone, without anything to see yet.
[[nodiscard]] ModelView begin_view(const ReportContext& context, const glm::dvec3& direction,
                                   const glm::dvec3& to_viewer);
/// The part for a page's view, its facets in the groups of the regions; opened, core and cavity surface come
/// apart.
[[nodiscard]] ModelView region_view(const ReportContext& context, const Classification& result,
                                    const glm::dvec3& to_viewer, std::span<const StillCallout> callouts = {});

/// How the view is used.
[[nodiscard]] std::string view_caption();

/// Of a comparison that has what becomes of the mold.
[[nodiscard]] Section mold_change_section(const Comparison& comparison);

/// Both parts, their facets in the groups of the regions, beside each other until they are moved over each
/// other, with what differs lit.
[[nodiscard]] ModelView comparison_view(const ReportContext& context, const Comparison& comparison,
                                        const glm::dvec3& to_viewer);

// live.cpp: reports whose page finds the regions of any direction by itself.

/// The map of undercut as the page's ball has it; rows from below.
[[nodiscard]] Image sphere_texture(const UndercutField& field);

/// What the page's maps of this resolution are by the program's own: as wide as the part is across the
/// direction, so that a map over the whole diagonal has more texels; one-sided; and no test nearer beside a
/// wall than the texel that is looked up reaches.
[[nodiscard]] Query page_query(const PartModel& model, const Query& query, int resolution);

/// Makes the report's page live where the context asks for it: adds the part, the exact areas of `known` (the
/// direction of the view first), and how far areas by shadow maps are off, which is measured along the axes,
/// between them and along `known`. A large part is drawn coarser, which the report says. Throws Cancelled.
void add_live(const ReportContext& context, const Classification& shown, std::vector<LiveDirection> known,
              Report& report);

}  // namespace moldlight::report
