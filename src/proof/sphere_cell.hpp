// Cells of directions: spherical triangles over the half-sphere, quartered as long as it takes.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace moldlight {

/// A spherical triangle, counter-clockwise seen from outside, and the cap around it. All directions are unit
/// vectors.
class SphereCell {
 public:
  explicit SphereCell(const std::array<glm::dvec3, 3>& corners);

  [[nodiscard]] const std::array<glm::dvec3, 3>& corners() const { return corners_; }
  /// Centre and angle of a cap that contains the cell; the cap is a little wider than the circle through the
  /// corners, by far more than rounding.
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }
  [[nodiscard]] double radius_deg() const;
  [[nodiscard]] double radius_rad() const { return radius_rad_; }
  /// Of the half-sphere, (0, 1].
  [[nodiscard]] double share() const;
  [[nodiscard]] bool contains(const glm::dvec3& direction) const;
  /// The triangle of the sides' middles last, the others at the corners.
  [[nodiscard]] std::array<SphereCell, 4> quarters() const;

 private:
  std::array<glm::dvec3, 3> corners_;
  glm::dvec3 centre_;
  double radius_rad_;
};

/// The four octants with z >= 0. With the opposites of its directions a half-sphere is all.
[[nodiscard]] std::array<SphereCell, 4> half_sphere_cells();

}  // namespace moldlight
