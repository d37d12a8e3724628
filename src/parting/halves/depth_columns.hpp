// Where lines through a solid, all along one way and on an even grid, enter and leave it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A way through solids, and two axes across it; orthonormal.
struct WayFrame {
  glm::dvec3 across{1, 0, 0}, up{0, 1, 0}, way{0, 0, 1};

  [[nodiscard]] glm::dvec3 of(const glm::dvec3& at) const {
    return {across.x * at.x + across.y * at.y + across.z * at.z, up.x * at.x + up.y * at.y + up.z * at.z,
            way.x * at.x + way.y * at.y + way.z * at.z};
  }
};

/// For a unit way; upward is along z where it lies across that.
[[nodiscard]] WayFrame frame_along(const glm::dvec3& way);

/// Lines at the middles of `count` times `count` equal cells of a rectangle across the way.
struct LineGrid {
  glm::dvec2 low{0.0}, high{0.0};
  std::size_t count = 64;

  /// Over a mesh's vertices.
  [[nodiscard]] static LineGrid over(const TriangleMesh& mesh, const WayFrame& frame, std::size_t count);
  [[nodiscard]] std::size_t lines() const { return count * count; }
  [[nodiscard]] glm::dvec2 at(std::size_t line) const;
};

/// A stretch of a line inside of the solid, and the facets through which it is entered and left.
struct Stretch {
  double from = 0.0, to = 0.0;  // along the way
  FacetIndex enters = 0, leaves = 0;
};

/// Of each line, from below. What is inside of several bodies counts once; a line that meets an edge may miss
/// a stretch.
[[nodiscard]] std::vector<std::vector<Stretch>> depth_columns(const TriangleMesh& mesh, const WayFrame& frame,
                                                              const LineGrid& grid);

/// The shortest way through a solid along x, y or z between facets that face away from each other within 20
/// degrees, on lines through all of it; none where there is none.
[[nodiscard]] std::optional<double> thinnest_of(const TriangleMesh& mesh);

}  // namespace moldlight
