// Pictures of a report, by the still pictures' painter.
#include <algorithm>

#include <fmt/format.h>

#include "classify/still_picture.hpp"
#include "render/camera.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr glm::ivec2 k_whole_px(1280, 800), k_behind_px(960, 600), k_undercut_px(280, 210);
/// More pictures of undercuts would make the page large, and nobody looks at them.
constexpr std::size_t k_most_row_pictures = 12, k_most_pictured_rows = 100;
/// What is shown around an undercut: shares of its extent and of the part's diagonal.
constexpr double k_around = 0.3, k_least_around = 0.06;

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

Image Illustrator::whole(std::span<const StillBody> bodies) {
  if (!painter_) return {};
  StillSettings still = still_settings(*context_, k_whole_px);
  still.seen_from = seen_from_;
  return painter_->draw(*result_, still, context_->progress, bodies);
}

Image Illustrator::from_behind() {
  if (!painter_) return {};
  StillSettings still = still_settings(*context_, k_behind_px);
  still.seen_from = looking_along(to_viewer(), result_->direction);
  return painter_->draw(*result_, still, context_->progress);
}

Image Illustrator::undercut(const Undercut& undercut) {
  if (!painter_) return {};
  const SplitMesh& split = *result_->split;
  const UnitFrame& frame = context_->model->frame;
  // Where this one alone is an undercut, it is what the view is chosen for.
  auto alone = std::make_shared<SplitMesh>(split);
  for (SplitPiece& piece : alone->pieces)
    if (piece.region == Region::undercut) piece.region = Region::both;
  Bounds box;
  for (const std::uint32_t piece : undercut.pieces) {
    alone->pieces[piece].region = Region::undercut;
    for (const VertexIndex corner : split.pieces[piece].corners)
      box.add(glm::dvec3(frame.to_unit(split.vertices[corner])));
  }
  StillSettings still = still_settings(*context_, k_undercut_px);
  still.look.arrows = false;
  const std::shared_ptr<const SplitMesh> shown = alone;
  still.seen_from = revealing_orientation(*context_->model, {&shown, 1}, result_->direction);
  const double room = std::max(k_around * box.diagonal(), k_least_around);
  for (const glm::dvec3& corner : box.widened(0.5 * room).corners()) still.focus.emplace_back(corner);
  return painter_->draw(*result_, still, context_->progress);
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
