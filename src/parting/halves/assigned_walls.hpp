// Upright walls of a part as they are assigned: the half that forms them, and the height at which the halves
// meet; both as ranges of the parting surface's height at the outline.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "parting/halves/plane_mesh.hpp"
#include "parting/halves/sheets.hpp"

namespace moldlight {

/// What the progress of all that makes the halves is called.
inline constexpr std::string_view k_halves_stage = "making the halves";
/// How far in the plane upright walls may be from where their ends stand, in tolerances.
inline constexpr double k_wall_reach = 4.0;

/// Upright surface that one half is to form.
struct AssignedWall {
  std::array<glm::dvec3, 3> corners{};
  bool core = true;
};
using LinePiece = std::array<glm::dvec3, 2>;

/// A point of the plane; at the outline, between what heights the surface has to be so that the halves touch
/// nowhere else.
struct OutlinePoint {
  glm::dvec2 at{0.0};
  HeightRange part;

  [[nodiscard]] bool on_outline() const { return std::isfinite(part.low) && std::isfinite(part.high); }
};

/// Ranges in these at which the walls are formed as assigned; where walls want the opposite, the middle.
/// Points farther from a wall than `reach` in the plane are not on it.
[[nodiscard]] std::vector<HeightRange> wall_ranges(std::span<const OutlinePoint> points,
                                                   std::span<const AssignedWall> walls, double reach);
/// The heights of the line where it passes a point within `reach` in the plane, as far as the part leaves
/// them. Throws Cancelled.
[[nodiscard]] std::vector<HeightRange> line_ranges(std::span<const OutlinePoint> points,
                                                   std::span<const LinePiece> line, double reach,
                                                   const Progress& progress);

/// Area of the walls that the other half forms between the sheets `lower` and `upper`, and where the most of
/// it is. With a sheet `parting`; walls farther than `reach` from the outline count as formed.
struct MissedWalls {
  double area = 0.0;
  std::optional<glm::dvec3> at;
  std::vector<double> met_area;  // of each wall, what of it is over the outline between the sheets
};
[[nodiscard]] MissedWalls missed_walls(const Sheets& sheets, std::span<const AssignedWall> walls,
                                       double reach);

}  // namespace moldlight
