#include "render/shown_points.hpp"

#include "render/view_geometry.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

std::vector<glm::vec3> points_to_show(std::span<const glm::vec3> extremes, const glm::dvec3& direction,
                                      double open_mold) {
  std::vector<glm::vec3> points(extremes.begin(), extremes.end());
  if (open_mold > 0.0) {
    const std::size_t count = points.size();
    const glm::vec3 travel(direction * open_mold * k_mold_travel);
    points.reserve(2 * count);
    for (std::size_t k = 0; k < count; ++k) {
      points.push_back(points[k] - travel);
      points[k] += travel;
    }
  }
  // The arrows and their names are to be seen too.
  for (const glm::dvec3& toward : {direction, -direction})
    points.emplace_back(parting_arrow(extremes, toward, open_mold).tip);
  return points;
}

}  // namespace moldlight
