// Maps of the parting directions: a value over the half-sphere, the map, and the colours of
// undercut areas, from a pale one for none to a dark one for the worst, with steadily falling lightness, so
// that every eye and a gray print read it.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mold/region.hpp"

namespace moldlight {

/// A value interpolated from directions that were evaluated so far: Shepard's inverse distance weights on an
/// equal-area grid (Lambert), so that each new direction is added once. A direction and its opposite count as
/// one.
class DirectionField {
 public:
  /// `reach_deg`: from an evaluated direction to where its value says nothing any more, (0, 90]. `cells`:
  /// along the diameter of the half-sphere's map, at least 2.
  explicit DirectionField(double reach_deg, int cells = 96);

  /// `direction` is a unit vector.
  void add(const glm::dvec3& direction, double value);

  struct Reading {
    double value = 0.0;
    double cover = 0.0;  // [0, 1]: 0 beyond the reach of every direction that was added
  };
  [[nodiscard]] Reading at(const glm::dvec3& direction) const;
  [[nodiscard]] bool empty() const { return empty_; }

 private:
  struct Cell {
    double weights = 0.0, weighted = 0.0;  // sums
    double nearest = 2.0;                  // least squared sine of the angle to an added direction
  };
  [[nodiscard]] Reading reading(int x, int y) const;

  int cells_;    // along a side of the grid, which is wider than the half-sphere's map by a margin
  double span_;  // of the grid, on the map's plane
  double reach_;
  bool empty_ = true;
  std::vector<glm::dvec3> directions_;
  std::vector<Cell> grid_;
};

/// A reach for DirectionField where about `directions` spread evenly over the half-sphere are added: it
/// leaves no gaps between them. In degrees.
[[nodiscard]] double even_set_reach_deg(int directions);

/// Lambert's equal-area map about +z: the half-sphere z >= 0 fills the unit disc. Directions below it lie
/// outside, up to a radius of sqrt(2); -z has no place of its own.
[[nodiscard]] glm::dvec2 equal_area_point(const glm::dvec3& direction);
[[nodiscard]] glm::dvec3 equal_area_direction(const glm::dvec2& point);

/// Place of an area on the scale, [0, 1]: the square root of its share of `worst`, which spreads the small
/// areas that matter.
[[nodiscard]] double undercut_scale(double area, double worst);
/// `place` in [0, 1].
[[nodiscard]] Colour undercut_scale_colour(double place);

}  // namespace moldlight
