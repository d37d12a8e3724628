#include "mesh/polygon_triangulation.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

using Point = std::array<double, 2>;

/// Share of the polygon's area that a fan triangle may be turned over by, for rounding in nearly straight
/// corners.
constexpr double k_fan_tolerance = 1e-9;

/// Area vector of the polygon (Newell), relative to its first corner.
glm::dvec3 area_vector(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

/// No triangle of the fan from corner 0 is turned over. True also for a polygon that has no area anywhere.
bool fan_covers(std::span<const glm::dvec3> corners, const glm::dvec3& area) {
  const double least = -k_fan_tolerance * glm::dot(area, area);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const glm::dvec3 triangle = glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    if (glm::dot(triangle, area) < least) return false;
    if (area == glm::dvec3(0.0) && triangle != glm::dvec3(0.0)) return false;
  }
  return true;
}

double twice_area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

PolygonCut PolygonTriangulator::triangulate(std::span<const glm::dvec3> corners,
                                            std::vector<std::array<std::uint32_t, 3>>& triangles) {
  triangles.clear();
  const auto count = static_cast<std::uint32_t>(corners.size());
  const glm::dvec3 area = area_vector(corners);
  const bool covered = count == 3 || fan_covers(corners, area);
  if (!covered && area != glm::dvec3(0.0)) {
    // Seen along the axis nearest to the normal, the outline keeps its shape best.
    const glm::dvec3 size = {std::abs(area.x), std::abs(area.y), std::abs(area.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double turn = area[axis] >= 0.0 ? 1.0 : -1.0;
    outline_.clear();
    for (const glm::dvec3& corner : corners) {
      outline_.push_back({turn * (corner[u] - corners[0][u]), corner[v] - corners[0][v]});
    }
    if (clip_ears(triangles)) return PolygonCut::ears;
    triangles.clear();
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return covered ? PolygonCut::fan : PolygonCut::fan_of_odd;
}

bool PolygonTriangulator::clip_ears(std::vector<std::array<std::uint32_t, 3>>& triangles) {
  left_.resize(outline_.size());
  for (std::uint32_t i = 0; i < left_.size(); ++i) left_[i] = i;
  std::size_t tip = 1, refused = 0;
  bool take_straight_corners = false;
  while (left_.size() > 3) {
    const std::size_t n = left_.size();
    if (work_left_ < n) return false;
    work_left_ -= n;
    const std::size_t before = (tip + n - 1) % n, after = (tip + 1) % n;
    if (!is_ear(before, tip, after, take_straight_corners)) {
      tip = after;
      if (++refused < n) continue;
      if (take_straight_corners) return false;
      take_straight_corners = true;
      refused = 0;
      continue;
    }
    take_straight_corners = false;
    triangles.push_back({left_[before], left_[tip], left_[after]});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(tip));
    // The corner after the ear stays put, so that cuts spread round the outline instead of piling up at one
    // corner.
    if (tip == left_.size()) tip = 0;
    refused = 0;
  }
  triangles.push_back({left_[0], left_[1], left_[2]});
  return twice_area(outline_[left_[0]], outline_[left_[1]], outline_[left_[2]]) >= 0.0;
}

/// No other corner may lie in the ear or on its rim, save one in the same place as a corner of the ear.
/// Straight corners are left for last, since a cut there makes a triangle without area.
bool PolygonTriangulator::is_ear(std::size_t before, std::size_t tip, std::size_t after,
                                 bool straight) const {
  const Point& a = outline_[left_[before]];
  const Point& b = outline_[left_[tip]];
  const Point& c = outline_[left_[after]];
  if (twice_area(a, b, c) <= 0.0) return straight && twice_area(a, b, c) == 0.0;
  for (std::size_t i = 0; i < left_.size(); ++i) {
    if (i == before || i == tip || i == after) continue;
    const Point& p = outline_[left_[i]];
    if (p == a || p == b || p == c) continue;
    if (twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0) return false;
  }
  return true;
}

}  // namespace moldlight
