#include "support/exact_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace moldlight::test {

ExactModel::ExactModel(TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      geometry_(facet_geometry(mesh_)),
      frame_(unit_frame(bounds(mesh_))),
      part_(mesh_, geometry_, frame_, Progress{}) {}

ExactQuery ExactModel::query(const glm::dvec3& direction, const ShapeSettings& settings) const {
  return {.direction = glm::normalize(direction),
          .tau_deg = settings.tau_deg,
          .lateral = settings.lateral_tolerance / frame_.diagonal};
}

ExactAreas ExactModel::areas(const glm::dvec3& direction, const ShapeSettings& settings) const {
  return exact_areas(part_, query(direction, settings), Progress{});
}

ExactSplit ExactModel::split(const glm::dvec3& direction, const ShapeSettings& settings) const {
  return exact_split(part_, query(direction, settings), Progress{});
}

ShapeSettings ExactModel::default_settings() const {
  return {.tau_deg = 1.0, .lateral_tolerance = frame_.diagonal / 2048.0};
}

ExactAreas exact_areas_of(const TriangleMesh& mesh, const glm::dvec3& direction,
                          const ShapeSettings& settings) {
  return ExactModel(mesh).areas(direction, settings);
}

double largest_difference(const RegionValues& a, const RegionValues& b) {
  double largest = 0.0;
  for (const Region region : k_regions) largest = std::max(largest, std::abs(a[region] - b[region]));
  return largest;
}

RegionValues swapped_sides(RegionValues areas) {
  std::swap(areas[Region::core], areas[Region::cavity]);
  return areas;
}

std::vector<glm::dvec3> five_directions() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.36, 0.48, 0.8}, glm::normalize(glm::dvec3(1, 2, 3))};
}

}  // namespace moldlight::test
