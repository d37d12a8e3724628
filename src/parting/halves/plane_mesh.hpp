// Constrained Delaunay triangulation of a rectangle (Lawson 1977; segments by flips: Sloan 1993). Points are
// on a grid, so that on which side of a line a point lies is exact.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace moldlight {

struct HeightRange {
  double low = -INFINITY, high = INFINITY;

  [[nodiscard]] bool empty() const { return low > high; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  [[nodiscard]] bool takes(double z, double slack) const { return z >= low - slack && z <= high + slack; }
};

/// Points are numbered in the order in which they are added, the rectangle's corners first (0 … 3,
/// counter-clockwise from the lowest). Coordinates are multiples of 2^-45 below 8.
class PlaneMesh {
 public:
  static constexpr std::uint32_t k_none = ~0U;
  struct Triangle {
    std::array<std::uint32_t, 3> corners{};  // counter-clockwise
    std::array<std::uint32_t, 3> across{};   // triangle across side k, from corner k to k + 1
    std::array<std::uint8_t, 3> fixed{};     // not 0: side k is a segment, of this kind
    bool inside = false;                     // as find_inside() found it
    std::uint32_t region = 0;                // of the plane outside
  };
  static constexpr std::uint8_t k_rim = 1, k_outline = 2;  // kinds of segments; the rectangle's sides are rim

  PlaneMesh(const glm::dvec2& low, const glm::dvec2& high);

  /// Number of the point; that of an equal one if there is one. It must be in the rectangle. On a segment it
  /// divides it.
  std::uint32_t add_point(const glm::dvec2& at);

  /// What stood in the way of a segment: a point on it, or another segment that crosses it.
  struct Obstacle {
    std::uint32_t point = k_none;
    std::array<std::uint32_t, 2> segment{k_none, k_none};
  };
  /// Makes the segment an edge; nothing where it became one.
  [[nodiscard]] std::optional<Obstacle> add_segment(std::uint32_t a, std::uint32_t b, std::uint8_t kind);

  /// Divides a segment at a point that is on it but for rounding; its number, or none where that would turn a
  /// triangle over.
  [[nodiscard]] std::uint32_t divide_segment(std::uint32_t a, std::uint32_t b, const glm::dvec2& at);

  /// Marks the triangles that lie inside of the outline: an odd number of its segments away from the
  /// rectangle's sides; numbers the regions outside, the one at the rectangle first. What is added later
  /// keeps to it.
  void find_inside();
  [[nodiscard]] std::size_t region_count() const { return regions_; }

  [[nodiscard]] const std::vector<glm::dvec2>& points() const { return points_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

  /// The triangle that the point lies in or on.
  [[nodiscard]] std::uint32_t locate(const glm::dvec2& at) const;

  /// Twice the signed area's sign, exact.
  [[nodiscard]] static int side_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

 private:
  struct Edge {
    std::uint32_t triangle, side;
  };
  [[nodiscard]] std::uint32_t side_towards(std::uint32_t triangle, std::uint32_t neighbour) const;
  void set_across(std::uint32_t triangle, std::uint32_t neighbour, std::uint32_t becomes);
  void legalize(std::vector<Edge> edges);
  [[nodiscard]] bool should_flip(const Edge& edge) const;
  void flip(const Edge& edge);
  void split_triangle(std::uint32_t triangle, std::uint32_t point, std::vector<Edge>& edges);
  void split_side(const Edge& edge, std::uint32_t point, std::vector<Edge>& edges);
  /// Calls visit(edge) for the triangles around a point, each by the side that begins there, until it returns
  /// true.
  template <typename Visit>
  void visit_around(std::uint32_t point, const Visit& visit) const;
  [[nodiscard]] std::optional<Edge> edge_between(std::uint32_t a, std::uint32_t b) const;
  void note(std::uint32_t triangle);
  void number_regions();

  std::vector<glm::dvec2> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> triangle_at_;  // one of each point
  std::size_t regions_ = 1;
  mutable std::uint32_t last_ = 0;
};

}  // namespace moldlight
