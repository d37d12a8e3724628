#include "support/map_lookup.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "classify/classifier.hpp"
#include "mold/measure.hpp"
#include "mold/second_depth.hpp"

namespace moldlight::test {

namespace {

/// As in the shader: rounding of n.p - c at coordinates up to 0.5 in single precision.
constexpr float k_plane_rounding = 2.5e-7F;

bool outside_of(const PartModel& model, std::uint32_t entry, const glm::vec3& point) {
  if (entry == 0) return false;
  const glm::vec3 normal(model.geometry.normals[entry - 1]);
  const glm::dvec3 corner =
      (model.part.mesh.corner(entry - 1, 0) - model.frame.center) / model.frame.diagonal;
  const auto offset = static_cast<float>(glm::dot(model.geometry.normals[entry - 1], corner));
  return glm::dot(normal, point) - offset > -k_plane_rounding;
}

}  // namespace

ScannedMaps::ScannedMaps(std::shared_ptr<const PartModel> of_model, const Query& query)
    : model(std::move(of_model)),
      frame(map_frame(query.direction.unit())),
      resolution(query.method.resolution),
      lateral(static_cast<float>(map_settings(query.method, model->frame.diagonal).lateral)),
      classes(facet_classes(model->geometry, frame.z, query.method.tau_deg)) {
  const std::vector<glm::vec3> positions = unit_positions(model->part.mesh, model->frame);
  SecondDepthMaps maps(resolution);
  maps.draw({model->part.mesh, positions, model->geometry.normals, model->edges.concave}, frame, classes,
            query.method.edge_thickness);
  facets = {maps.facets(false), maps.facets(true)};
}

std::uint32_t ScannedMaps::entry(bool plus, int x, int y) const {
  if (x < 0 || y < 0 || x >= resolution || y >= resolution) return 0;
  return facets[plus ? 1 : 0][static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution) +
                              static_cast<std::size_t>(x)];
}

std::uint8_t accessible_from(const ScannedMaps& maps, const glm::vec3& point, FacetIndex facet) {
  const PartModel& model = *maps.model;
  const glm::vec3 direction(maps.frame.z);
  const FacetClass facet_class = maps.classes[facet];
  glm::vec3 at = point;
  if (facet_class == FacetClass::near_vertical) {
    const glm::vec3 normal(model.geometry.normals[facet]);
    at += maps.lateral * glm::normalize(normal - glm::dot(normal, direction) * direction);
  }
  const auto texel = [&](const glm::dvec3& axis) {
    return static_cast<int>(
        std::floor((glm::dot(at, glm::vec3(axis)) + 0.5F) * static_cast<float>(maps.resolution)));
  };
  const int x = texel(maps.frame.x), y = texel(maps.frame.y);
  const std::uint32_t plus = maps.entry(true, x, y), minus = maps.entry(false, x, y);
  const bool blocked_plus = outside_of(model, plus, at), blocked_minus = outside_of(model, minus, at);
  if (facet_class == FacetClass::up) return blocked_plus ? 0 : verdict::k_accessible_plus;
  if (facet_class == FacetClass::down) return blocked_minus ? 0 : verdict::k_accessible_minus;
  // Between the two maps' facets, which face away from each other, there is solid: the look-up fell into a
  // ledge.
  if (plus != 0 && minus != 0 && !blocked_plus && !blocked_minus) return 0;
  return static_cast<std::uint8_t>((blocked_plus ? 0 : verdict::k_accessible_plus) |
                                   (blocked_minus ? 0 : verdict::k_accessible_minus));
}

}  // namespace moldlight::test
