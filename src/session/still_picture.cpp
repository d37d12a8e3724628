#include "session/still_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "picture/legend.hpp"
#include "render/offscreen_picture.hpp"
#include "render/part_view.hpp"
#include "render/parting_arrow.hpp"
#include "session/figures.hpp"
#include "session/still_layout.hpp"
#include "session/view_choice.hpp"

namespace moldlight {

namespace {

constexpr int k_samples = 32;
constexpr int k_texels_per_pixel = 2, k_most_texels = 4096;  // of the maps, along their sides

glm::dquat orientation(const PartModel& model, const Classification& result, PictureView view) {
  switch (view) {
    case PictureView::automatic:
      return revealing_orientation(model, result);
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

/// The classification's own settings, but for maps so fine that their texels do not show.
MethodSettings picture_settings(const Classification& result, const glm::ivec2& size) {
  MethodSettings settings = result.settings;
  if (settings.kernel_shape == KernelShape::symmetric || result.lateral_tolerance <= 0.0) return settings;
  settings.tolerance = result.lateral_tolerance;
  settings.resolution =
      std::max(settings.resolution, std::min(k_most_texels, k_texels_per_pixel * std::max(size.x, size.y)));
  return settings;
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
  content.note = fmt::format("undercut ± {} {}  ·  two checks {}", areas.text(result.uncertainty.total),
                             content.unit, result.projected.agrees() ? "agree" : "disagree");
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

Image still_picture(const gl::Context& context, Classifier& classifier, const Classification& result,
                    const StillSettings& settings) {
  validate(settings);
  const PartModel& model = classifier.model();
  const glm::ivec2& size = settings.size;
  classifier.draw_maps(picture_settings(result, size));

  const LegendContent content = legend_content(model, result);
  const StillLayout places = still_layout(size, settings.legend ? &content : nullptr);

  const ViewGeometry geometry = view_geometry(model.part.mesh, model.geometry, model.adjacency, model.frame);
  const std::array<PartingArrow, 2> arrows = {parting_arrow(geometry.extremes, result.direction, 0.0),
                                              parting_arrow(geometry.extremes, -result.direction, 0.0)};
  Camera camera;
  camera.orientation = orientation(model, result, settings.view);
  camera.projection = settings.view == PictureView::automatic || settings.view == PictureView::isometric
                          ? Projection::perspective
                          : Projection::orthographic;
  camera.fov_deg = 22.0;

  ViewSettings view_settings;
  view_settings.theme = settings.theme;
  view_settings.palette = settings.palette;
  view_settings.parting_arrows = settings.arrows;
  view_settings.pixel_scale = std::max(1.0, 1.15 * places.scale);
  view_settings.samples = k_samples;
  PartView view(context.functions(), geometry);
  std::vector<glm::vec3> beyond;
  if (settings.arrows) beyond = {glm::vec3(arrows[0].tip), glm::vec3(arrows[1].tip)};
  camera = composed(context.functions(), view, classifier, camera,
                    {size, places.legend, geometry.extremes, beyond});
  const OffscreenPicture picture(context.functions(), size);
  view.draw_final(picture.target(), classifier.buffers(), classifier.maps(), camera, view_settings);

  Canvas canvas(picture.read());
  const LegendStyle style{
      .dark = settings.theme == Theme::dark, .palette = settings.palette, .scale = places.scale};
  if (settings.arrows && places.legend) {
    label_arrow(canvas, view, camera, size, arrows[0], "core", style);
    label_arrow(canvas, view, camera, size, arrows[1], "cavity", style);
  }
  if (places.legend) draw_legend(canvas, places.legend->corner, content, style);
  return canvas.image();
}

}  // namespace moldlight
