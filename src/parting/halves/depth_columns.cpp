#include "parting/halves/depth_columns.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/facet_geometry.hpp"

namespace moldlight {

namespace {

struct Meeting {
  double at = 0.0;
  int sign = 0;  // 1: the solid begins
  FacetIndex facet = 0;
};

}  // namespace

WayFrame frame_along(const glm::dvec3& way) {
  if (way.z == 0.0) return {glm::dvec3(-way.y, way.x, 0.0), glm::dvec3(0.0, 0.0, 1.0), way};
  const glm::dvec3 across =
      way.x == 0.0 && way.y == 0.0 ? glm::dvec3(1, 0, 0) : glm::normalize(glm::dvec3(-way.y, way.x, 0.0));
  return {across, glm::cross(way, across), way};
}

LineGrid LineGrid::over(const TriangleMesh& mesh, const WayFrame& frame, std::size_t count) {
  LineGrid grid{glm::dvec2(INFINITY), glm::dvec2(-INFINITY), count};
  for (const glm::dvec3& vertex : mesh.vertices) {
    grid.low = glm::min(grid.low, glm::dvec2(frame.of(vertex)));
    grid.high = glm::max(grid.high, glm::dvec2(frame.of(vertex)));
  }
  return grid;
}

glm::dvec2 LineGrid::at(std::size_t line) const {
  const glm::dvec2 cell(static_cast<double>(line % count) + 0.5, static_cast<double>(line / count) + 0.5);
  return low + cell / static_cast<double>(count) * (high - low);
}

std::vector<std::vector<Stretch>> depth_columns(const TriangleMesh& mesh, const WayFrame& frame,
                                                const LineGrid& grid) {
  std::vector<std::vector<Meeting>> met(grid.lines());
  const double count = static_cast<double>(grid.count);
  const glm::dvec2 cell = (grid.high - grid.low) / count;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 a = frame.of(mesh.corner(facet, 0)), b = frame.of(mesh.corner(facet, 1)),
                     c = frame.of(mesh.corner(facet, 2));
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0.0) continue;
    const glm::dvec2 least = glm::dvec2(glm::min(a, glm::min(b, c))),
                     most = glm::dvec2(glm::max(a, glm::max(b, c)));
    const glm::dvec2 first = glm::clamp(glm::ceil((least - grid.low) / cell - 0.5), 0.0, count),
                     last = glm::clamp(glm::floor((most - grid.low) / cell - 0.5), -1.0, count - 1.0);
    for (double y = first.y; y <= last.y; y += 1.0) {
      for (double x = first.x; x <= last.x; x += 1.0) {
        const std::size_t line = static_cast<std::size_t>(y) * grid.count + static_cast<std::size_t>(x);
        const glm::dvec2 at = grid.at(line);
        const double in_a = ((b.x - at.x) * (c.y - at.y) - (b.y - at.y) * (c.x - at.x)) / area,
                     in_b = ((c.x - at.x) * (a.y - at.y) - (c.y - at.y) * (a.x - at.x)) / area;
        if (in_a < 0.0 || in_b < 0.0 || in_a + in_b > 1.0) continue;
        met[line].push_back(
            {in_a * a.z + in_b * b.z + (1.0 - in_a - in_b) * c.z, area < 0.0 ? 1 : -1, facet});
      }
    }
  }
  std::vector<std::vector<Stretch>> columns(grid.lines());
  for (std::size_t line = 0; line < met.size(); ++line) {
    std::ranges::stable_sort(met[line], {}, &Meeting::at);
    int depth = 0;
    for (const Meeting& meeting : met[line]) {
      const int before = depth;
      depth += meeting.sign;
      if (before <= 0 && depth > 0) columns[line].push_back({meeting.at, meeting.at, meeting.facet, 0});
      if (before > 0 && depth <= 0 && !columns[line].empty()) {
        columns[line].back().to = meeting.at;
        columns[line].back().leaves = meeting.facet;
      }
    }
  }
  return columns;
}

std::optional<double> thinnest_of(const TriangleMesh& mesh) {
  constexpr std::size_t k_lines = 96;
  const double least_cosine = std::cos(glm::radians(20.0));
  const auto normal_of = [&](FacetIndex facet) { return glm::normalize(twice_area_vector(mesh, facet)); };
  const Bounds box = bounds(mesh);
  std::optional<double> thinnest;
  for (int axis = 0; axis < 3; ++axis) {
    WayFrame frame{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
    frame.way[axis] = frame.across[(axis + 1) % 3] = frame.up[(axis + 2) % 3] = 1.0;
    const LineGrid grid{glm::dvec2(frame.of(box.min)), glm::dvec2(frame.of(box.max)), k_lines};
    for (const std::vector<Stretch>& column : depth_columns(mesh, frame, grid)) {
      for (const Stretch& stretch : column) {
        const double way = stretch.to - stretch.from;
        if (way <= 0.0 || (thinnest && way >= *thinnest)) continue;
        if (glm::dot(normal_of(stretch.enters), normal_of(stretch.leaves)) <= -least_cosine) thinnest = way;
      }
    }
  }
  return thinnest;
}

}  // namespace moldlight
