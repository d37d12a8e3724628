// The triangle mesh: a plain value.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

using VertexIndex = std::uint32_t;
using FacetIndex = std::uint32_t;

/// Marks "no facet", so a mesh holds at most 2^32 - 2 facets.
inline constexpr FacetIndex k_no_facet = std::numeric_limits<FacetIndex>::max();

/// Triangles over shared vertices, in the order of the file as it is read; corners run counter-clockwise seen
/// from outside. Coordinates are finite and in the part's own unit.
struct TriangleMesh {
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<VertexIndex, 3>> facets;

  /// Corner `corner` (0, 1, 2) of facet `facet`.
  [[nodiscard]] const glm::dvec3& corner(FacetIndex facet, int corner) const {
    return vertices[facets[facet][static_cast<std::size_t>(corner)]];
  }
  [[nodiscard]] glm::dvec3 middle(FacetIndex facet) const {
    return (corner(facet, 0) + corner(facet, 1) + corner(facet, 2)) / 3.0;
  }
};

/// Axis-aligned box; min > max for a mesh without facets.
struct Bounds {
  glm::dvec3 min{std::numeric_limits<double>::infinity()};
  glm::dvec3 max{-std::numeric_limits<double>::infinity()};

  /// Makes the box as large as it must be to hold the point.
  void add(const glm::dvec3& point);
  [[nodiscard]] glm::dvec3 center() const;
  /// Length of the box's diagonal; 0 for a mesh without facets.
  [[nodiscard]] double diagonal() const;
  /// Its eight corners.
  [[nodiscard]] std::array<glm::dvec3, 8> corners() const;
  /// The box that is larger by this length to every side.
  [[nodiscard]] Bounds widened(double length) const { return {min - length, max + length}; }
};

/// Between two numbers of single precision as large as the mesh's coordinates.
[[nodiscard]] double rounding_step(const TriangleMesh& mesh);

/// Box of the vertices that facets use.
[[nodiscard]] Bounds bounds(const TriangleMesh& mesh);

/// Adds the surface of a solid to a mesh; nothing is welded.
void append(const TriangleMesh& solid, TriangleMesh& mesh);

}  // namespace moldlight
