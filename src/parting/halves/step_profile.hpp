// A parting surface of steps: its heights change along one direction of the plane alone, from level to level
// by steep ramps, so that each of its faces is a plane and is milled across in one go. Away from the part it
// comes down, or up, to one level, so that the block's edge is flat.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <glm/vec2.hpp>

#include "parting/halves/rim_segment.hpp"

namespace moldlight {

/// What of the outline is met but for this much, in diagonals of the part, is met.
inline constexpr double k_step_slack = 1e-5;

class StepProfile {
 public:
  struct Knot {
    double place = 0.0, height = 0.0;
  };
  /// Knots by place, at least two; level before the first and behind the last.
  using Knots = std::vector<Knot>;
  /// Where the plane is parted along the direction, each side has heights of its own: the first what is
  /// nearer to minus infinity across it, as seen along it what is on the right.
  struct Sides {
    double parted_at = INFINITY;
    std::array<Knots, 2> knots;  // the second is empty where it is not parted
  };

  /// `along`: unit.
  StepProfile(const glm::dvec2& along, Sides sides) : along_(along), sides_(std::move(sides)) {}

  /// Comes to one of its levels, that of the greatest part of what is around the outline, beyond a rectangle
  /// around this by a land and ramps.
  void level_around(const std::vector<RimSegment>& rims, const ShelfShape& shape);

  [[nodiscard]] double at(const glm::dvec2& place) const;
  /// The level around the rectangle.
  [[nodiscard]] double base() const { return base_; }
  [[nodiscard]] const glm::dvec2& along() const { return along_; }
  [[nodiscard]] std::size_t bends() const { return sides_.knots[0].size() + sides_.knots[1].size(); }
  /// What of the outline's length it does not meet.
  [[nodiscard]] double missed_share(const std::vector<RimSegment>& rims) const;
  /// From its lowest level to its highest one.
  [[nodiscard]] double rise() const;
  /// Straight lines at which the surface bends, for a rectangle of the plane.
  [[nodiscard]] std::vector<std::array<glm::dvec2, 2>> creases(const glm::dvec2& low,
                                                               const glm::dvec2& high) const;
  /// Corners of the rectangle outside of which it is level; none where it goes on for ever.
  [[nodiscard]] std::vector<glm::dvec2> level_corners() const;

 private:
  using Line = std::array<glm::dvec2, 2>;  // from and to, each across and along

  [[nodiscard]] glm::dvec2 in_plane(const glm::dvec2& at) const {
    return at.y * along_ + at.x * glm::dvec2(along_.y, -along_.x);
  }
  [[nodiscard]] glm::dvec2 of_plane(const glm::dvec2& place) const {
    return {glm::dot(glm::dvec2(along_.y, -along_.x), place), glm::dot(along_, place)};
  }
  /// How far from the rectangle a height above the base, or below it, is left.
  [[nodiscard]] double left_at(double above) const;
  /// Those of the heights of one side, wherever that is.
  [[nodiscard]] std::vector<Line> creases_of(const Knots& knots) const;
  [[nodiscard]] std::vector<Line> creases_before(const Knot& knot, double edge, double way) const;

  glm::dvec2 along_;
  Sides sides_;
  double base_ = 0.0;
  bool levels_ = false;
  double ramp_ = 1.0;
  std::array<double, 2> most_{};     // above the base and below it
  glm::dvec2 low_{0.0}, high_{0.0};  // of the rectangle: across, along
};

}  // namespace moldlight
