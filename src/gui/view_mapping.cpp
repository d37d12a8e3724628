#include "gui/view_mapping.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace moldlight::gui {

namespace {

constexpr double k_fill = 0.92;  // of the free area

}  // namespace

ViewSettings view_settings(const LookSettings& look, const MethodSettings& method, Theme theme,
                           const Extent& extent, double open_mold, double pixel_scale) {
  ViewSettings view;
  view.theme = theme;
  view.palette = look.palette;
  view.colour_mode = look.colouring == Colouring::regions ? ColourMode::regions : ColourMode::draft_angle;
  view.regions_by = look.regions_by;
  view.mark_difference = look.mark_difference;
  view.hatch_undercut = look.hatching;
  view.feature_edges = look.feature_edges;
  view.facet_edges = look.facet_edges;
  view.contour_edges = look.contour_edges;
  view.near_vertical = look.near_vertical;
  view.parting_arrows = look.arrows;
  view.tau_deg = method.tau_deg;
  view.open_mold = open_mold * k_mold_travel;
  view.others_opacity = look.others_opacity;
  if (look.section) view.section = extent.min + look.section_height * (extent.max - extent.min);
  view.pixel_scale = pixel_scale;
  return view;
}

PartingArrow parting_arrow_of(std::span<const glm::vec3> extremes, const glm::dvec3& toward,
                              double open_mold) {
  return parting_arrow(extremes, toward, open_mold * k_mold_travel);
}

Camera fitted_to(const Camera& camera, std::span<const glm::vec3> extremes, const glm::dvec3& direction,
                 double open_mold, const FreeArea& area) {
  std::vector<glm::vec3> points(extremes.begin(), extremes.end());
  if (open_mold > 0.0) {
    const std::size_t count = points.size();
    const glm::vec3 travel(glm::normalize(direction) * open_mold * k_mold_travel);
    points.reserve(2 * count);
    for (std::size_t k = 0; k < count; ++k) {
      points.push_back(points[k] - travel);
      points[k] += travel;
    }
  }
  // The arrows and their names are to be seen too.
  const glm::dvec3 unit = glm::normalize(direction);
  for (const glm::dvec3& toward : {unit, -unit})
    points.emplace_back(parting_arrow_of(extremes, toward, open_mold).tip);
  const glm::ivec2 free = glm::max(area.max - area.min, glm::ivec2(64));
  Camera fit = fitted(camera, points, free, k_fill);
  // The free area's picture, seen as a part of the window's.
  const double pixel = fit.height / free.y;
  const glm::dvec2 offset = 0.5 * glm::dvec2(area.min + area.max - area.window) * pixel;
  fit.height = pixel * area.window.y;
  fit.target += offset.y * fit.up() - offset.x * fit.right();
  return fit;
}

}  // namespace moldlight::gui
