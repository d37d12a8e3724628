// Pictures of a report, by the still pictures' painter.
#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "classify/still_picture.hpp"
#include "render/camera.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr glm::ivec2 k_whole_px(1280, 800), k_behind_px(800, 500), k_row_px(240, 180);
/// More pictures of undercuts would make the page large, and nobody looks at them.
constexpr std::size_t k_most_row_pictures = 12, k_most_pictured_rows = 100;
/// Numbers beyond these would cover the part.
constexpr std::size_t k_most_callouts = 20, k_most_callout_places = 12;
/// What is shown around an undercut: shares of its extent and of the part's diagonal.
constexpr double k_around = 0.3, k_least_around = 0.06;

/// `box` in the unit frame.
void take_focus(const Bounds& box, StillSettings& still) {
  still.focus.clear();
  const double room = std::max(k_around * box.diagonal(), k_least_around);
  for (const glm::dvec3& corner : box.widened(0.5 * room).corners()) still.focus.emplace_back(corner);
}

void add_segments(const PartingLoop& loop, const UnitFrame& frame, std::vector<ViewSegment>& segments) {
  for (std::size_t k = 0; k < loop.points.size(); ++k)
    segments.push_back(
        {frame.to_unit(loop.points[k]), frame.to_unit(loop.points[(k + 1) % loop.points.size()])});
}

}  // namespace

StillSettings still_settings(const ReportContext& context, const glm::ivec2& size) {
  StillSettings still;
  still.size = size;
  still.legend = false;
  still.backdrop = Backdrop::none;
  still.look.palette = context.palette;
  return still;
}

Illustrator::Illustrator(const ReportContext& context, const Classification& result)
    : context_(&context), result_(&result) {
  if (!context.drawn()) return;
  painter_.emplace(*context.gl, context.model);
  seen_from_ = painter_->seen_best({&result, 1});
}

glm::dvec3 Illustrator::to_viewer() const { return seen_from_ * glm::dvec3(0, 0, 1); }

Image Illustrator::whole(std::vector<StillCallout> callouts, std::span<const StillBody> bodies) {
  if (!painter_) return {};
  StillSettings still = still_settings(*context_, k_whole_px);
  still.seen_from = seen_from_;
  still.callouts = std::move(callouts);
  still.scale_bar = true;
  return painter_->draw(*result_, still, context_->progress, bodies);
}

Image Illustrator::from_behind() {
  if (!painter_) return {};
  StillSettings still = still_settings(*context_, k_behind_px);
  still.seen_from = looking_along(to_viewer(), result_->direction);
  return painter_->draw(*result_, still, context_->progress);
}

/// The part with `pieces` as its only undercut, which is what the view is chosen for, and the room around
/// them.
StillSettings Illustrator::close_up(std::span<const std::uint32_t> pieces, SplitMesh& alone) const {
  const UnitFrame& frame = context_->model->frame;
  for (SplitPiece& piece : alone.pieces)
    if (piece.region == Region::undercut) piece.region = Region::both;
  Bounds box;
  for (const std::uint32_t piece : pieces) {
    alone.pieces[piece].region = Region::undercut;
    for (const VertexIndex corner : alone.pieces[piece].corners)
      box.add(glm::dvec3(frame.to_unit(alone.vertices[corner])));
  }
  StillSettings still = still_settings(*context_, k_row_px);
  still.look.arrows = false;
  const auto shown = std::make_shared<const SplitMesh>(alone);
  still.seen_from = revealing_orientation(*context_->model, {&shown, 1}, result_->direction);
  take_focus(box, still);
  return still;
}

Image Illustrator::undercut(const Undercut& undercut) {
  if (!painter_) return {};
  Classification alone = *result_;
  auto split = std::make_shared<SplitMesh>(*result_->split);
  const StillSettings still = close_up(undercut.pieces, *split);
  alone.split = std::move(split);
  return painter_->draw(alone, still, context_->progress);
}

Image Illustrator::line(const PartingLine& line, std::vector<StillCallout> callouts) {
  if (!painter_) return {};
  StillSettings still = still_settings(*context_, k_behind_px);
  still.seen_from = seen_from_;
  still.callouts = std::move(callouts);
  for (const PartingLoop& loop : line.loops)
    if (loop.kind != LoopKind::action) add_segments(loop, context_->model->frame, still.line);
  return painter_->draw(*result_, still, context_->progress);
}

Image Illustrator::loop(const PartingLine& line, std::size_t number) {
  if (!painter_) return {};
  const PartingLoop& loop = line.loops[number];
  std::vector<bool> on_loop(result_->split->vertices.size(), false);
  for (const VertexIndex vertex : loop.vertices) on_loop[vertex] = true;
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t piece = 0; piece < result_->split->pieces.size(); ++piece)
    if (std::ranges::any_of(result_->split->pieces[piece].corners, [&](VertexIndex v) { return on_loop[v]; }))
      pieces.push_back(piece);
  SplitMesh beside = *result_->split;
  StillSettings still = close_up(pieces, beside);
  add_segments(loop, context_->model->frame, still.lit_line);
  Bounds box;
  for (const glm::dvec3& point : loop.points) box.add(glm::dvec3(context_->model->frame.to_unit(point)));
  take_focus(box, still);
  return painter_->draw(*result_, still, context_->progress);
}

std::vector<StillCallout> undercut_callouts(const SplitMesh& split,
                                            std::span<const Undercut* const> undercuts) {
  std::vector<StillCallout> callouts;
  for (std::size_t k = 0; k < std::min(undercuts.size(), k_most_callouts); ++k) {
    struct Spot {
      glm::dvec3 middle, across;  // as long as twice the area
    };
    std::vector<Spot> places;
    for (const std::uint32_t piece : undercuts[k]->pieces) {
      const auto& [a, b, c] = split.pieces[piece].corners;
      const glm::dvec3 &p = split.vertices[a], &q = split.vertices[b], &r = split.vertices[c];
      places.push_back({(p + q + r) / 3.0, glm::cross(q - p, r - p)});
    }
    std::ranges::stable_sort(places, std::greater{}, [](const Spot& one) { return glm::length(one.across); });
    places.resize(std::min(places.size(), k_most_callout_places));
    StillCallout callout{fmt::format("{}", k + 1), {}, glm::normalize(places.front().across)};
    for (const Spot& one : places) callout.places.push_back(one.middle);
    callouts.push_back(std::move(callout));
  }
  return callouts;
}

std::vector<StillCallout> loop_callouts(const PartingLine& line, std::span<const std::size_t> loops) {
  std::vector<StillCallout> callouts;
  for (const std::size_t number : loops.first(std::min(loops.size(), k_most_callouts))) {
    const std::vector<glm::dvec3>& points = line.loops[number].points;
    StillCallout callout{fmt::format("{}", number + 1), {}};
    for (std::size_t k = 0; k < k_most_callout_places; ++k)
      callout.places.push_back(points[k * points.size() / k_most_callout_places]);
    callouts.push_back(std::move(callout));
  }
  return callouts;
}

Table undercut_table(const ReportContext& context, Illustrator& pictures,
                     std::span<const Undercut* const> undercuts, const UndercutTotals& totals,
                     const Place& keys) {
  const FigureStyle style(*context.model);
  Table table{{{"#"}}, {}};
  add_columns(style, undercut_sizes(), table);
  table.columns.push_back({style.heading("centre", FigureKind::length), true});
  for (std::size_t k = 0; k < std::min(undercuts.size(), k_most_pictured_rows); ++k) {
    Row row{{{fmt::format("{}", k + 1)}}};
    add_cells(style, found_figures(undercut_sizes(), *undercuts[k]), entry_of(keys, k), row);
    row.cells.push_back({with_minus(style.point(undercuts[k]->centre))});
    if (k < k_most_row_pictures) {
      row.picture = pictures.undercut(*undercuts[k]);
      row.picture_text = fmt::format("Undercut {}", k + 1);
    }
    table.rows.push_back(std::move(row));
  }
  if (undercuts.size() > k_most_pictured_rows) table.rest = fmt::format("… {} in all.", undercuts.size());
  if (totals.specks > 0)
    table.tiny = fmt::format("{} ({})", tiny_text(totals.specks),
                             style.with_unit(FigureKind::area, totals.speck_area));
  return table;
}

}  // namespace moldlight::report
