#include "session/still_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "gl/colour_target.hpp"
#include "mold/exact/exact_regions.hpp"
#include "picture/legend.hpp"
#include "render/view_geometry.hpp"
#include "session/figures.hpp"
#include "session/still_layout.hpp"
#include "session/view_choice.hpp"

namespace moldlight {

namespace {

constexpr int k_samples = 32;

glm::dquat orientation(const PartModel& model, const SplitMesh& split, const glm::dvec3& direction,
                       PictureView view) {
  switch (view) {
    case PictureView::automatic:
      return revealing_orientation(model, split, direction);
    case PictureView::isometric:
      return standard_orientation(StandardView::isometric);
    case PictureView::front:
      return standard_orientation(StandardView::front);
    case PictureView::back:
      return standard_orientation(StandardView::back);
    case PictureView::left:
      return standard_orientation(StandardView::left);
    case PictureView::right:
      return standard_orientation(StandardView::right);
    case PictureView::top:
      return standard_orientation(StandardView::top);
    case PictureView::bottom:
      break;
  }
  return standard_orientation(StandardView::bottom);
}

std::shared_ptr<const SplitMesh> exact_regions(const PartModel& model, const Classification& result,
                                               const Progress& progress) {
  if (result.split) return result.split;
  const ExactQuery query{.direction = result.direction,
                         .tau_deg = result.settings.tau_deg,
                         .lateral = result.lateral_tolerance / model.frame.diagonal};
  return std::make_shared<const SplitMesh>(exact_split(model.exact(progress), query, progress).mesh);
}

LegendContent legend_content(const PartModel& model, const Classification& result) {
  LegendContent content;
  content.title = part_name(model.part);
  content.lines.push_back(fmt::format("parting direction {}", figures(result.direction, 1.0)));
  content.lines.push_back(fmt::format("draft tolerance {}°, lateral tolerance {:.3g} {}",
                                      figure(result.settings.tau_deg), result.lateral_tolerance,
                                      length_unit(model.part)));
  const FigureColumn areas(result.total_area);
  for (const Region region : k_regions) {
    const auto index = static_cast<std::size_t>(region);
    content.shares[index] = result.total_area > 0.0 ? result.areas[region] / result.total_area : 0.0;
    content.percents[index] = fmt::format("{:.2f}", 100.0 * content.shares[index]);
    content.areas[index] = areas.text(result.areas[region]);
  }
  content.unit = powered_unit(model.part, 2);
  content.note = fmt::format("undercut ± {:.2g} {}  ·  two checks {}", result.uncertainty.total(),
                             content.unit, result.identity.agrees() ? "agree" : "disagree");
  return content;
}

/// Says which half comes off along an arrow, where its tip is not behind the part.
void label_arrow(Canvas& canvas, const PartView& view, const Camera& camera, const glm::ivec2& size,
                 const PartingArrow& arrow, std::string_view label, const LegendStyle& style) {
  const auto tip = project(camera, size, arrow.tip), tail = project(camera, size, arrow.tail);
  if (!tip || !tail) return;
  const auto seen = view.pick(glm::ivec2(*tip));
  if (seen && glm::dot(glm::dvec3(seen->position) - arrow.tip, camera.toward_viewer()) > 0.0) return;
  const glm::dvec2 along =
      glm::distance(*tip, *tail) > 1.0 ? glm::normalize(*tip - *tail) : glm::dvec2(0, -1);
  const glm::dvec2 room = tag_size(canvas, label, style);
  draw_tag(canvas, *tip + along * (6.0 * style.scale + 0.5 * glm::dot(glm::abs(along), room)), label, style);
}

}  // namespace

void validate(const StillSettings& settings) {
  for (const int side : {settings.size.x, settings.size.y}) {
    if (side < k_least_picture_px || side > k_most_picture_px) {
      throw UsageError(fmt::format("--size: {}x{} is out of range, {} to {} pixels a side", settings.size.x,
                                   settings.size.y, k_least_picture_px, k_most_picture_px));
    }
  }
}

StillPainter::StillPainter(const gl::Context& context, std::shared_ptr<const PartModel> model)
    : context_(&context),
      model_(std::move(model)),
      geometry_(view_geometry(model_->part.mesh, model_->geometry, model_->adjacency, model_->frame)),
      maps_(context, model_),
      view_(context.functions(), geometry_) {}

Image StillPainter::draw(const Classification& result, const StillSettings& settings,
                         const Progress& progress) {
  validate(settings);
  const glm::ivec2& size = settings.size;
  const auto split = exact_regions(*model_, result, progress);
  if (settings.regions_by == RegionsBy::maps || settings.mark_difference) maps_.draw_resting(result.settings);
  maps_.take_split(*split, geometry_, result.settings);

  const LegendContent content = legend_content(*model_, result);
  const StillLayout places = still_layout(size, settings.legend ? &content : nullptr);
  const std::array<PartingArrow, 2> arrows = {parting_arrow(geometry_.extremes, result.direction, 0.0),
                                              parting_arrow(geometry_.extremes, -result.direction, 0.0)};
  Camera camera;
  camera.orientation = orientation(*model_, *split, result.direction, settings.view);
  camera.projection = settings.view == PictureView::automatic || settings.view == PictureView::isometric
                          ? Projection::perspective
                          : Projection::orthographic;
  camera.fov_deg = 22.0;

  ViewSettings view_settings;
  view_settings.theme = settings.theme;
  view_settings.palette = settings.palette;
  view_settings.regions_by = settings.regions_by;
  view_settings.mark_difference = settings.mark_difference;
  view_settings.parting_arrows = settings.arrows;
  view_settings.pixel_scale = std::max(1.0, 1.15 * places.scale);
  view_settings.samples = k_samples;
  std::vector<glm::vec3> beyond;
  if (settings.arrows) beyond = {glm::vec3(arrows[0].tip), glm::vec3(arrows[1].tip)};
  camera = composed(context_->functions(), view_, maps_.buffers(), camera,
                    {size, places.legend, geometry_.extremes, beyond});
  const gl::ColourTarget picture(context_->functions(), size);
  view_.draw_final({picture.framebuffer(), size}, maps_.subject(), camera, view_settings);

  Canvas canvas({size.x, size.y, picture.read()});
  const LegendStyle style{
      .dark = settings.theme == Theme::dark, .palette = settings.palette, .scale = places.scale};
  if (settings.arrows && places.legend) {
    label_arrow(canvas, view_, camera, size, arrows[0], "core", style);
    label_arrow(canvas, view_, camera, size, arrows[1], "cavity", style);
  }
  if (places.legend) draw_legend(canvas, places.legend->corner, content, style);
  return canvas.image();
}

}  // namespace moldlight
