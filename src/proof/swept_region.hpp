// Where the rays from a point or a triangle run whose directions are in a cone: a convex region, by its
// half-spaces.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

namespace moldlight {

/// Rays start within `radius` of `points` (one, or the corners of a triangle) or between them; their
/// directions are the positive combinations of `directions`, three to eight unit vectors that span a convex
/// cone counter-clockwise seen from outside, narrower than a half-space. Unit frame.
struct RayBundle {
  std::span<const glm::dvec3> points;
  double radius = 0.0;
  std::span<const glm::dvec3> directions;
  glm::dvec3 centre{0, 0, 1};  // unit, within the cone
};

/// Contains every point that a ray of the bundle meets, and a little more.
class SweptRegion {
 public:
  explicit SweptRegion(const RayBundle& bundle);

  /// True if some of the line from `a` to `b` may lie inside.
  [[nodiscard]] bool meets(const glm::dvec3& a, const glm::dvec3& b) const;

 private:
  void add(const RayBundle& bundle, const glm::dvec3& normal);
  void add_edge_planes(const RayBundle& bundle);

  struct HalfSpace {
    glm::dvec3 normal;
    double offset;
  };
  std::array<HalfSpace, 32> half_spaces_;
  std::size_t count_ = 0;
};

}  // namespace moldlight
