// Points of the plane by the cells of an even grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

namespace moldlight {

/// Items that lie at points; `cell` is the edge length of a cell, over 0.
class PlaneGrid {
 public:
  explicit PlaneGrid(double cell) : cell_(cell) {}

  void add(const glm::dvec2& at, std::uint32_t item) {
    cells_[key(place(at.x), place(at.y))].push_back(item);
  }

  /// Every item within half a cell of the point, and others.
  template <typename Visit>
  void for_each_near(const glm::dvec2& at, const Visit& visit) const {
    const std::int64_t x0 = place(at.x - 0.5 * cell_), x1 = place(at.x + 0.5 * cell_),
                       y0 = place(at.y - 0.5 * cell_), y1 = place(at.y + 0.5 * cell_);
    for (std::int64_t x = x0; x <= x1; ++x) {
      for (std::int64_t y = y0; y <= y1; ++y) visit_cell(x, y, visit);
    }
  }

  /// Every item within a quarter of a cell of the segment, and others.
  template <typename Visit>
  void for_each_along(const glm::dvec2& a, const glm::dvec2& b, const Visit& visit) const {
    const double reach = 0.25 * cell_;
    const std::int64_t first = place(std::min(a.x, b.x) - reach), last = place(std::max(a.x, b.x) + reach);
    const double slope = a.x == b.x ? 0.0 : (b.y - a.y) / (b.x - a.x);
    for (std::int64_t x = first; x <= last; ++x) {
      double y0 = std::min(a.y, b.y), y1 = std::max(a.y, b.y);
      if (a.x != b.x && first != last) {
        const double left = a.y + (static_cast<double>(x) * cell_ - reach - a.x) * slope,
                     right = a.y + (static_cast<double>(x + 1) * cell_ + reach - a.x) * slope;
        y0 = std::max(y0, std::min(left, right));
        y1 = std::min(y1, std::max(left, right));
      }
      for (std::int64_t y = place(y0 - reach); y <= place(y1 + reach); ++y) visit_cell(x, y, visit);
    }
  }

 private:
  [[nodiscard]] std::int64_t place(double at) const {
    return static_cast<std::int64_t>(std::floor(at / cell_));
  }
  [[nodiscard]] static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL) ^
           (static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL);
  }
  template <typename Visit>
  void visit_cell(std::int64_t x, std::int64_t y, const Visit& visit) const {
    const auto found = cells_.find(key(x, y));
    if (found == cells_.end()) return;
    for (const std::uint32_t item : found->second) visit(item);
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace moldlight
