// Delaunay refinement of a plane mesh (Ruppert 1995).
#include <algorithm>
#include <cmath>
#include <deque>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "parting/hull/plane_mesh.hpp"
#include "parting/hull/sheets.hpp"

namespace moldlight {

namespace {

/// Sine of the least angle: the shortest side over the circle's diameter.
double least_sine(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double ab = glm::distance(a, b), bc = glm::distance(b, c), ca = glm::distance(c, a);
  const double twice_area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const double shortest = std::min({ab, bc, ca});
  return ab * bc * ca > 0.0 ? shortest * twice_area / (ab * bc * ca) : 0.0;
}

glm::dvec2 circle_centre(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 p = b - a, q = c - a;
  const double pp = glm::dot(p, p), qq = glm::dot(q, q), twice = 2.0 * (p.x * q.y - p.y * q.x);
  return a + glm::dvec2(q.y * pp - p.y * qq, p.x * qq - q.x * pp) / twice;
}

}  // namespace

template <typename Visit>
void PlaneMesh::for_each_around(std::uint32_t point, const Visit& visit) const {
  for (const bool forward : {true, false}) {
    std::uint32_t triangle = triangle_at_[point];
    const std::uint32_t first = triangle;
    do {
      if (forward || triangle != first) visit(triangle);
      const Triangle& t = triangles_[triangle];
      const std::uint32_t k = t.corners[0] == point ? 0 : t.corners[1] == point ? 1 : 2;
      triangle = t.across[forward ? (k + 2) % 3 : k];
    } while (triangle != k_none && triangle != first);
    if (triangle == first) return;
  }
}

void PlaneMesh::find_inside() {
  std::vector<std::uint8_t> depth(triangles_.size(), 2);
  std::deque<std::uint32_t> queue;
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
    const auto& across = triangles_[k].across;
    if (across[0] != k_none && across[1] != k_none && across[2] != k_none) continue;
    depth[k] = 0;
    queue.push_back(k);
  }
  while (!queue.empty()) {
    const std::uint32_t here = queue.front();
    queue.pop_front();
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t there = triangles_[here].across[side];
      if (there == k_none || depth[there] != 2) continue;
      depth[there] = triangles_[here].fixed[side] == k_outline ? 1 - depth[here] : depth[here];
      queue.push_back(there);
    }
  }
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) triangles_[k].inside = depth[k] == 1;
}

std::optional<PlaneMesh::Edge> PlaneMesh::segment_towards(std::uint32_t triangle,
                                                          const glm::dvec2& at) const {
  for (std::size_t step = 0; step < 4 * triangles_.size(); ++step) {
    const Triangle& t = triangles_[triangle];
    std::uint32_t side = 3;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t turned = (k + static_cast<std::uint32_t>(step % 3)) % 3;
      if (side_of(points_[t.corners[turned]], points_[t.corners[(turned + 1) % 3]], at) < 0) side = turned;
    }
    if (side == 3) return std::nullopt;
    if (t.fixed[side] != 0 || t.across[side] == k_none) return Edge{triangle, side};
    triangle = t.across[side];
  }
  return std::nullopt;
}

bool PlaneMesh::halve(const Edge& edge, double least_segment) {
  const Triangle& t = triangles_[edge.triangle];
  const glm::dvec2 &a = points_[t.corners[edge.side]], &b = points_[t.corners[(edge.side + 1) % 3]];
  if (glm::distance(a, b) < least_segment) return false;
  const glm::dvec2 middle = on_grid(0.5 * (a + b));
  if (middle == a || middle == b) return false;
  // It may lie beside the segment by a cell of the grid, which must not turn a triangle over.
  for (const std::uint32_t number : {edge.triangle, t.across[edge.side]}) {
    if (number == k_none) continue;
    const Triangle& u = triangles_[number];
    const std::uint32_t side = number == edge.triangle ? edge.side : side_towards(number, edge.triangle);
    const glm::dvec2 &from = points_[u.corners[side]], &to = points_[u.corners[(side + 1) % 3]],
                     &tip = points_[u.corners[(side + 2) % 3]];
    if (side_of(middle, to, tip) <= 0 || side_of(from, middle, tip) <= 0) return false;
  }
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(middle);
  triangle_at_.push_back(edge.triangle);
  std::vector<Edge> edges;
  split_side(edge, point, edges);
  legalize(std::move(edges));
  return true;
}

void PlaneMesh::refine(const Refinement& refinement) {
  const double sine = std::sin(glm::radians(refinement.least_angle_deg));
  struct Bad {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> corners;
  };
  std::deque<Bad> queue;
  const auto look_at = [&](std::uint32_t number) {
    const Triangle& t = triangles_[number];
    if (!t.inside && least_sine(points_[t.corners[0]], points_[t.corners[1]], points_[t.corners[2]]) < sine)
      queue.push_back({number, t.corners});
  };
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) look_at(k);
  const std::size_t most = points_.size() + refinement.most_points;
  const auto encroached = [&](const Edge& edge, const glm::dvec2& at) {
    const Triangle& t = triangles_[edge.triangle];
    return t.fixed[edge.side] != 0 &&
           glm::dot(points_[t.corners[edge.side]] - at, points_[t.corners[(edge.side + 1) % 3]] - at) < 0.0;
  };
  while (!queue.empty() && points_.size() < most) {
    const Bad bad = queue.front();
    queue.pop_front();
    if (triangles_[bad.triangle].corners != bad.corners) continue;
    const auto& [a, b, c] = bad.corners;
    const glm::dvec2 centre = on_grid(circle_centre(points_[a], points_[b], points_[c]));
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) continue;
    std::optional<Edge> segment = segment_towards(bad.triangle, centre);
    if (!segment) {
      const std::uint32_t within = locate(centre);
      for (std::uint32_t side = 0; side < 3 && !segment; ++side) {
        if (encroached({within, side}, centre)) segment = Edge{within, side};
      }
    }
    const auto count = static_cast<std::uint32_t>(points_.size());
    if (segment) {
      if (!halve(*segment, refinement.least_segment)) continue;
      look_at(bad.triangle);
    } else if (add_point(centre) != count) {
      continue;
    }
    for_each_around(count, look_at);
  }
}

}  // namespace moldlight
