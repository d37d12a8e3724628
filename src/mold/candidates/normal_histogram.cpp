#include "mold/candidates/normal_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mold/candidates/candidate.hpp"

namespace moldlight {
namespace {

constexpr double k_cells_per_unit = 573.0;  // a tenth of a degree

std::uint64_t cell_key(const glm::dvec3& normal) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = key << 12 | static_cast<std::uint64_t>(std::lround((normal[axis] + 1.0) * k_cells_per_unit));
  }
  return key;
}

}  // namespace

std::vector<NormalCell> normal_histogram(const FacetGeometry& geometry) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> facets;
  facets.reserve(geometry.areas.size());
  for (std::uint32_t facet = 0; facet < geometry.areas.size(); ++facet) {
    if (geometry.areas[facet] > 0.0)
      facets.emplace_back(cell_key(half_sphere(geometry.normals[facet])), facet);
  }
  std::sort(facets.begin(), facets.end());

  std::vector<NormalCell> cells;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (i == 0 || facets[i].first != facets[i - 1].first) cells.emplace_back();
    const std::uint32_t facet = facets[i].second;
    cells.back().normal += geometry.areas[facet] * half_sphere(geometry.normals[facet]);
    cells.back().area += geometry.areas[facet];
  }
  for (NormalCell& cell : cells) cell.normal = half_sphere(glm::normalize(cell.normal));
  std::stable_sort(cells.begin(), cells.end(),
                   [](const NormalCell& a, const NormalCell& b) { return a.area > b.area; });
  return cells;
}

NormalCell mean_normal(const std::vector<NormalCell>& cells, const glm::dvec3& normal, double radius_deg) {
  const double least_cosine = std::cos(glm::radians(radius_deg));
  NormalCell mean;
  for (const NormalCell& cell : cells) {
    const double cosine = glm::dot(cell.normal, normal);
    if (std::abs(cosine) < least_cosine) continue;
    mean.normal += cosine < 0.0 ? -cell.area * cell.normal : cell.area * cell.normal;
    mean.area += cell.area;
  }
  mean.normal = mean.area > 0.0 ? half_sphere(glm::normalize(mean.normal)) : normal;
  return mean;
}

}  // namespace moldlight
