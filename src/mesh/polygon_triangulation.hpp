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
  /// `work_limit`: number of point-in-triangle tests after which concave polygons are cut as fans.
  explicit PolygonTriangulator(std::uint64_t work_limit) : work_left_(work_limit) {}

  /// Fills `triangles` with the n - 2 triangles of the polygon, as numbers of its corners and in its winding.
  /// A fan from corner 0 wherever that covers the polygon; returns fan_of_odd where a fan had to do for one
  /// that it does not cover: the outline crosses itself, or the work limit is used up. `corners` holds at
  /// least 3 finite points.
  PolygonCut triangulate(std::span<const glm::dvec3> corners,
                         std::vector<std::array<std::uint32_t, 3>>& triangles);

 private:
  [[nodiscard]] bool clip_ears(std::vector<std::array<std::uint32_t, 3>>& triangles);
  [[nodiscard]] bool is_ear(std::size_t before, std::size_t tip, std::size_t after, bool straight) const;

  std::uint64_t work_left_;
  std::vector<std::array<double, 2>> outline_;  // the polygon in its plane, counter-clockwise
  std::vector<std::uint32_t> left_;             // corners not yet clipped
};

}  // namespace moldlight
