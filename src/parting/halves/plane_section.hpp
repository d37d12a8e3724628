// The section of a solid in a plane, divided into facets.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "parting/halves/depth_columns.hpp"

namespace moldlight {

using DirectedEdge = std::array<VertexIndex, 2>;

/// What lies within closed outlines in a plane across the frame's way, as facets that face along it, of the
/// outlines' own corners. `size`: a length of which the section is at most some times as large. Nothing where
/// outlines cross or touch.
[[nodiscard]] std::optional<std::vector<std::array<VertexIndex, 3>>> section_facets(
    std::span<const glm::dvec3> vertices, std::span<const DirectedEdge> outlines, const WayFrame& frame,
    double size);

}  // namespace moldlight
