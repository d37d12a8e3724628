// Surface that is undercut for every direction of a cell, and for the opposite ones.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "proof/blocked_cone.hpp"
#include "proof/surface_elements.hpp"

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

/// What a direction's exact regions are found with (see ExactQuery).
struct ProofQuery {
  double tau_deg = 1.0;  // [0, 45]
  double lateral = 0.0;  // lateral tolerance in the unit frame
};

/// What is known of an element for a cell.
struct ElementAnswer {
  double certain_area = 0.0;      // model units squared; all of the element's but for its rim, or nothing
  bool hidden_at_centre = false;  // along the cell's middle direction the element's middle is undercut
  double distance = 0.0;          // of what hides it; unit frame
};

/// One thread's room. The rule, for the facet's normal n, t = tau and any direction d of the cell:
/// - where n . d >= sin t may be, all rays along d from the element itself must be blocked;
/// - where n . d <= -sin t may be, all along -d;
/// - where the facet may be near-vertical both, from the element moved by the lateral tolerance h across d.
///   The angle from n to h is the draft angle, less than t, so h ends in a ball about the end of n.
/// Angles are bounded by the cap around the cell, not by its corners. A triangle is asked for as shrunk by
/// 1e-5, so that what it touches is clear of it; its rim counts as free.
class CertainUndercut {
 public:
  CertainUndercut(const ProofPart& part, const ProofQuery& query);

  [[nodiscard]] ElementAnswer ask(const SurfaceElement& element, const SphereCell& cell);

  /// Whether none of the cell's directions releases the element, the opposite ones left aside: by the same
  /// rule, and each that it faces away from by tau does not.
  [[nodiscard]] bool blocked_along(const SurfaceElement& element, const SphereCell& cell);

 private:
  struct Start {
    std::array<glm::dvec3, 3> corners;
    std::size_t count;
    double radius;
  };
  [[nodiscard]] Start own_start(const SurfaceElement& element) const;
  [[nodiscard]] Start start_beside(const Start& own, const glm::dvec3& normal) const;
  [[nodiscard]] bool blocked(const Start& start, const SphereCell& cell, double sense, ElementAnswer& answer);
  [[nodiscard]] bool blocked_above(const Start& start, const SphereCell& cell, double sense,
                                   const glm::dvec3& normal, ElementAnswer& answer);
  [[nodiscard]] bool keep(const ConeAnswer& cone, ElementAnswer& answer) const;

  const ProofPart& part_;
  double tau_rad_, lateral_;
  BlockedCone cone_;
};

}  // namespace moldlight
