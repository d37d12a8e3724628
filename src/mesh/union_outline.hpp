// The outline of what triangles in a plane cover together.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace moldlight {

/// Loops around what is covered, counter-clockwise; around holes clockwise. Corners lie within k_outline_step
/// of where they belong, and what is narrower than twenty of it may be missing. Coordinates in [-2, 2].
/// Nothing where it cannot be known: beyond `most_edges` of triangles' sides that may be part of it, and
/// where slivers leave a loop open.
[[nodiscard]] std::optional<std::vector<std::vector<glm::dvec2>>> union_outline(
    std::span<const glm::dvec2> points, std::span<const std::array<std::uint32_t, 3>> triangles,
    std::size_t most_edges = 8000);
inline constexpr double k_outline_step = 1e-6;

/// Of all loops, holes taken off.
[[nodiscard]] double enclosed_area(std::span<const std::vector<glm::dvec2>> loops);

}  // namespace moldlight
