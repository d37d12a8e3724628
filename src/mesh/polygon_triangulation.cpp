#include "mesh/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  const auto count = static_cast<std::uint32_t>(outline_.size());
  if (!spend(count)) return false;
  next_.resize(count);
  previous_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    next_[i] = (i + 1) % count;
    previous_[i] = (i + count - 1) % count;
  }
  make_grid();
  std::uint32_t tip = 1, refused = 0;
  bool take_straight_corners = false;
  for (std::uint32_t left = count; left > 3;) {
    const std::uint32_t before = previous_[tip], after = next_[tip];
    if (!spend(1)) return false;
    if (!is_ear(tip, take_straight_corners)) {
      tip = after;
      if (++refused < left) continue;
      if (take_straight_corners) return false;
      take_straight_corners = true;
      refused = 0;
      continue;
    }
    take_straight_corners = false;
    triangles.push_back({before, tip, after});
    next_[before] = after;
    previous_[after] = before;
    next_[tip] = tip;
    // The corner after the ear stays put, so that cuts spread round the outline instead of piling up at one
    // corner.
    tip = next_[after];
    refused = 0;
    --left;
  }
  const std::uint32_t before = previous_[tip], after = next_[tip];
  triangles.push_back({before, tip, after});
  return twice_area(outline_[before], outline_[tip], outline_[after]) >= 0.0;
}

/// No other corner may lie in the ear or on its rim, save one in the same place as a corner of the ear.
/// Straight corners are left for last, since a cut there makes a triangle without area.
bool PolygonTriangulator::is_ear(std::uint32_t tip, bool straight) {
  const Point& a = outline_[previous_[tip]];
  const Point& b = outline_[tip];
  const Point& c = outline_[next_[tip]];
  if (twice_area(a, b, c) <= 0.0) return straight && twice_area(a, b, c) == 0.0;
  const auto in_ear = [&](std::uint32_t corner) {
    const Point& p = outline_[corner];
    if (next_[corner] == corner || p == a || p == b || p == c) return false;
    return twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0;
  };
  const auto low = cell_of({std::min({a[0], b[0], c[0]}), std::min({a[1], b[1], c[1]})});
  const auto high = cell_of({std::max({a[0], b[0], c[0]}), std::max({a[1], b[1], c[1]})});
  for (std::size_t row = low[1]; row <= high[1]; ++row) {
    const auto first = items_.begin() + first_item_[row * cells_[0] + low[0]];
    const auto last = items_.begin() + first_item_[row * cells_[0] + high[0] + 1];
    if (!spend(1 + static_cast<std::uint64_t>(last - first)) || std::any_of(first, last, in_ear))
      return false;
  }
  return true;
}

/// Square cells, as many as there are corners or a little more.
void PolygonTriangulator::make_grid() {
  Point low = outline_[0], high = outline_[0];
  for (const Point& point : outline_) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  const Point size = {high[0] - low[0], high[1] - low[1]};
  const auto count = static_cast<double>(outline_.size());
  const double cell = std::max({std::sqrt(size[0] * size[1] / count), size[0] / count, size[1] / count});
  origin_ = low;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    cells_per_length_[axis] = cell > 0.0 ? 1.0 / cell : 0.0;
    cells_[axis] = 1 + static_cast<std::size_t>(std::min(count, size[axis] * cells_per_length_[axis]));
  }
  const auto number = [this](const Point& point) {
    const auto cell_here = cell_of(point);
    return cell_here[1] * cells_[0] + cell_here[0];
  };
  first_item_.assign(cells_[0] * cells_[1] + 1, 0);
  for (const Point& point : outline_) ++first_item_[number(point) + 1];
  std::partial_sum(first_item_.begin(), first_item_.end(), first_item_.begin());
  std::vector<std::uint32_t> place(first_item_.begin(), first_item_.end() - 1);
  items_.resize(outline_.size());
  for (std::uint32_t i = 0; i < outline_.size(); ++i) items_[place[number(outline_[i])]++] = i;
}

std::array<std::size_t, 2> PolygonTriangulator::cell_of(const Point& point) const {
  std::array<std::size_t, 2> cell{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double cells = (point[axis] - origin_[axis]) * cells_per_length_[axis];
    // False for what is no number, too, as in outlines of hardly any extent.
    if (cells > 0.0)
      cell[axis] = static_cast<std::size_t>(std::min(cells, static_cast<double>(cells_[axis] - 1)));
  }
  return cell;
}

/// False where no work is left.
bool PolygonTriangulator::spend(std::uint64_t work) {
  const bool enough = work < work_left_;
  work_left_ = enough ? work_left_ - work : 0;
  return enough;
}

}  // namespace moldlight
