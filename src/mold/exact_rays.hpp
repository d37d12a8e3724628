// Exact visibility along straight rays (Embree): scores directions, finds what blocks a point, what is
// seen from where, and what lies near a point.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A search tree over one part, in the unit frame. Immutable, so that any number of threads may ask it.
class ExactRays {
 public:
  /// `positions` are the mesh's vertices in the unit frame.
  ExactRays(const TriangleMesh& mesh, std::span<const glm::vec3> positions);
  ~ExactRays();
  ExactRays(ExactRays&&) noexcept;
  ExactRays& operator=(ExactRays&&) noexcept;

  /// True if the ray from a point of a facet with unit normal `normal`, which faces along `direction`, runs
  /// into the solid. Only facets that face the ray count, so the point's own facet never hides it; the ray
  /// starts below the facet by the rounding of coordinates, so that a surface which touches the facet does.
  [[nodiscard]] bool surface_point_blocked(const glm::vec3& origin, const glm::vec3& normal,
                                           const glm::vec3& direction) const;

  enum class Blockage {
    none,
    ray,     // a facet stops it
    around,  // a facet stops it and surely all rays of its direction within the reach
  };
  /// What stops the ray from `origin` along `direction` (unit), and whether it stops those within `reach`
  /// (unit frame), too. Only facets that face the ray count.
  [[nodiscard]] Blockage blockage(const glm::vec3& origin, const glm::vec3& direction, float reach) const;

  /// Asks for many rays of one direction from points off the surface at once; `answers[i]` is 1 for a ray
  /// that meets any facet. Keep neighbouring origins next to each other.
  void blocked(std::span<const glm::vec3> origins, const glm::vec3& direction,
               std::span<std::uint8_t> answers) const;

  struct Hit {
    FacetIndex facet = 0;
    float distance = 0.0F;  // unit frame
  };
  /// First facet that the ray meets; with `facing_only`, the first that faces it.
  [[nodiscard]] std::optional<Hit> first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                             bool facing_only) const;

  /// Calls `visit` for the facets whose boxes come within `radius` (unit frame) of the point, none of them
  /// left out, some that are farther among them, in no order; it returns the radius that is of interest from
  /// then on, which may only shrink.
  void visit_near(const glm::vec3& point, float radius, const std::function<float(FacetIndex)>& visit) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// How a point beside a near-vertical facet is found. Unit frame.
struct AccessibilityQuery {
  glm::dvec3 direction{0, 0, 1};  // parting direction, unit
  double lateral = 0.0;           // lateral tolerance
};

/// The point from which a near-vertical facet's accessibility is tested: `point` moved by the lateral
/// tolerance along the part of `normal` that is perpendicular to the direction.
[[nodiscard]] glm::vec3 lateral_point(const glm::vec3& point, const glm::dvec3& normal,
                                      const AccessibilityQuery& query);

}  // namespace moldlight
