// Cutting a polygon in space into triangles: as a fan where that covers it, by ear clipping where it is
// concave.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

enum class PolygonCut : std::uint8_t { fan, ears, fan_of_odd };

/// Cuts polygons one after the other, with a bound on the work that hostile polygons can ask for.
class PolygonTriangulator {
 public:
  /// `work_limit`: number of steps after which concave polygons are cut as fans. A simple polygon of n
  /// corners takes some 100 n, hostile ones up to n² and more.
  explicit PolygonTriangulator(std::uint64_t work_limit) : work_left_(work_limit) {}

  /// Fills `triangles` with the n - 2 triangles of the polygon, as numbers of its corners and in its winding.
  /// A fan from corner 0 wherever that covers the polygon; returns fan_of_odd where a fan had to do for one
  /// that it does not cover: the outline crosses itself, or the work limit is used up. `corners` holds at
  /// least 3 finite points.
  PolygonCut triangulate(std::span<const glm::dvec3> corners,
                         std::vector<std::array<std::uint32_t, 3>>& triangles);

 private:
  using Point = std::array<double, 2>;

  [[nodiscard]] bool clip_ears(std::vector<std::array<std::uint32_t, 3>>& triangles);
  /// `straight`: corners without an angle may be cut off, too.
  [[nodiscard]] bool is_ear(std::uint32_t tip, bool straight);
  void make_grid();
  [[nodiscard]] std::array<std::size_t, 2> cell_of(const Point& point) const;
  [[nodiscard]] bool spend(std::uint64_t work);

  std::uint64_t work_left_;
  std::vector<Point> outline_;                  // the polygon in its plane, counter-clockwise
  std::vector<std::uint32_t> next_, previous_;  // of corners not yet clipped; a clipped one is its own next
  // A grid over the outline: the corners in cell i are items_[first_item_[i]] up to first_item_[i + 1].
  Point origin_{}, cells_per_length_{};
  std::array<std::size_t, 2> cells_{};
  std::vector<std::uint32_t> first_item_, items_;
};

}  // namespace moldlight
