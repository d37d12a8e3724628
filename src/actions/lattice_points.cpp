#include "actions/lattice_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace moldlight {

namespace {

/// From where to where along v a line at a height of u passes a triangle, seen along the third axis; the
/// first is infinite where it passes by.
std::pair<double, double> crossed(const std::array<glm::dvec3, 3>& corners, int u, int v, double at) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  const auto take = [&](double its) {
    first = std::min(first, its);
    last = std::max(last, its);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 &from = corners[k], &to = corners[(k + 1) % 3];
    if (at < std::min(from[u], to[u]) || at > std::max(from[u], to[u])) continue;
    const double width = to[u] - from[u];
    take(width == 0.0 ? to[v] : glm::mix(from[v], to[v], (at - from[u]) / width));
    if (width == 0.0) take(from[v]);
  }
  return {first, last};
}

}  // namespace

SurfacePoints lattice_points(const TriangleMesh& mesh, const glm::dvec3& way, const glm::dvec3& direction,
                             std::size_t count) {
  SurfacePoints points;
  const glm::dvec3 off = direction - glm::dot(direction, way) * way;
  const glm::dvec3 other = std::abs(way.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(way, glm::length(off) > 1e-3 ? off : other));
  const glm::dmat3 to_frame = glm::transpose(glm::dmat3(way, across, glm::cross(way, across)));
  std::vector<glm::dvec3> places;
  places.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices) places.push_back(to_frame * vertex);
  Bounds box;
  double passed = 0.0;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex corner : facet) box.add(places[corner]);
    const glm::dvec3& a = places[facet[0]];
    const glm::dvec3 area = glm::abs(glm::cross(places[facet[1]] - a, places[facet[2]] - a));
    passed += 0.5 * (area.x + area.y + area.z);
  }
  // A splinter would have too many.
  constexpr double k_least_step = 1e-3;  // of its length
  constexpr double k_no_splinter = 0.1, k_margin = 1e-3;
  const glm::dvec3 size = box.max - box.min;
  const double step = std::max(std::sqrt(passed / static_cast<double>(count)),
                               k_least_step * std::max({size.x, size.y, size.z}));
  if (!(step > 0.0)) return points;
  const glm::dvec3 middle = box.center();
  std::vector<glm::dvec3> in_steps;
  in_steps.reserve(places.size());
  for (const glm::dvec3& place : places) in_steps.push_back((place - middle) / step - 0.5);
  for (const auto& facet : mesh.facets) {
    const glm::dvec3 &a = places[facet[0]], &b = places[facet[1]], &c = places[facet[2]];
    const glm::dvec3 &one = in_steps[facet[0]], &two = in_steps[facet[1]], &three = in_steps[facet[2]];
    const glm::dvec3 low = glm::min(one, glm::min(two, three));
    const glm::dvec3 high = glm::max(one, glm::max(two, three));
    for (int k = 0; k < 3; ++k) {
      const int u = (k + 1) % 3, v = (k + 2) % 3;
      if (std::ceil(low[u]) > high[u]) continue;
      const double twice = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
      if (twice == 0.0) continue;
      // How far beside the line's crossings rounding may put points into a triangle, steps: far of a
      // splinter.
      const double margin = std::abs(twice) > k_no_splinter * step * step ? k_margin : 1.0;
      for (double i = std::ceil(low[u]); i <= high[u]; ++i) {
        const auto [first, last] = crossed({a, b, c}, u, v, middle[u] + (i + 0.5) * step);
        const double to = std::min(high[v], (last - middle[v]) / step - 0.5 + margin);
        for (double j = std::ceil(std::max(low[v], (first - middle[v]) / step - 0.5 - margin)); j <= to;
             ++j) {
          const double x = middle[u] + (i + 0.5) * step - a[u], y = middle[v] + (j + 0.5) * step - a[v];
          const double s = (x * (c[v] - a[v]) - y * (c[u] - a[u])) / twice;
          const double t = (y * (b[u] - a[u]) - x * (b[v] - a[v])) / twice;
          if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
          const bool few = std::llround(i - 1.0) % 3 == 0 && std::llround(j - 1.0) % 3 == 0;
          (few ? points.few : points.others)
              .push_back(glm::transpose(to_frame) * (a + s * (b - a) + t * (c - a)));
        }
      }
    }
  }
  if (points.few.empty() && points.others.empty()) points.others = mesh.vertices;
  // A thin body lies between most of those lines, or all of them.
  constexpr std::size_t k_least_few = 30;  // one in so many, where one in nine is expected
  if (k_least_few * points.few.size() < points.few.size() + points.others.size()) {
    points.few.insert(points.few.end(), points.others.begin(), points.others.end());
    points.others.clear();
  }
  return points;
}

}  // namespace moldlight
