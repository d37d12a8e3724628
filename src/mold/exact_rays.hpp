// Exact visibility along straight rays (Embree): settles what the maps leave in doubt and finds what blocks a
// point.
#pragma once

#include <cstdint>
#include <limits>
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
  /// into the solid within `reach` (in the direction's length). Only facets that face the ray count, so the
  /// point's own facet never hides it; the ray starts below the facet by the rounding of coordinates, so that
  /// a surface which touches the facet does.
  [[nodiscard]] bool surface_point_blocked(const glm::vec3& origin, const glm::vec3& normal,
                                           const glm::vec3& direction,
                                           float reach = std::numeric_limits<float>::infinity()) const;

  /// True if the ray from a point off the surface meets any facet.
  [[nodiscard]] bool blocked(const glm::vec3& origin, const glm::vec3& direction) const;

  /// blocked() for many rays of one direction at once, several times as fast; `answers[i]` is 1 for a blocked
  /// ray. Keep neighbouring origins next to each other.
  void blocked(std::span<const glm::vec3> origins, const glm::vec3& direction,
               std::span<std::uint8_t> answers) const;

  struct Hit {
    FacetIndex facet = 0;
    float distance = 0.0F;  // unit frame
  };
  /// First facet that the ray meets; with `facing_only`, the first that faces it.
  [[nodiscard]] std::optional<Hit> first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                             bool facing_only) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace moldlight
