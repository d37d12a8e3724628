// The parting line: the loops in which the surfaces of core, cavity and side actions meet, their figures, and
// the whole-number checks on them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "parting/assignment.hpp"

namespace moldlight {

enum class LoopKind : std::uint8_t { outer, shut_off, action };
/// "outer", "shut-off", "action".
[[nodiscard]] std::string_view loop_name(LoopKind kind);

/// Lengths in the part's unit.
struct PartingLoop {
  LoopKind kind = LoopKind::outer;
  std::uint32_t body = 0;             // connected component of the surface
  std::vector<VertexIndex> vertices;  // of the assignment's mesh; closed, the first is not repeated
  std::vector<glm::dvec3> points;     // where it runs: its vertices, moved where it was smoothed
  double length = 0.0;
  // Of what is not broken by a side action, all heights and slopes:
  double low = 0.0, high = 0.0;  // along the direction, in the part's coordinates
  double flatness = 0.0;         // greatest distance from its best plane
  double up_and_down = 0.0;      // all of its climbs and descents
  double steep_length = 0.0;     // of the runs that climb by more than 64 degrees
  double steep_draft_deg = 0.0;  // the greatest draft of facets at these
  double steepest_deg = 0.0;     // slope of its edges, [0, 90]
  double sharpest_deg = 180.0;   // the least angle between neighbouring edges
  double on_crease = 0.0;        // share of its length
  double area = 0.0;             // of its projection, positive where the core lies inside of it
  bool tiny = false;             // by is_tiny()
  std::size_t breaks = 0;        // runs where a side action takes the place of the other half
  double break_length = 0.0;
  std::size_t moved = 0;         // points that smoothing moved
  double smoothed_length = 0.0;  // by which it became shorter
  double smoothed_climb = 0.0;   // by which up_and_down became less

  [[nodiscard]] double climb() const { return high - low; }
};

/// Whether a loop is no wider than the lateral tolerance, by its length, or by its area and height where it
/// is short: rounding alone makes it one. Tables have one row for all of these.
[[nodiscard]] bool is_tiny(const PartingLoop& loop, double lateral_tolerance);

/// Euler characteristics, exact. A side's surface counts with its border; where the surface of a side touches
/// itself in a vertex, it counts as apart there.
struct EulerCheck {
  std::int64_t part = 0, core = 0, cavity = 0, action = 0;
  std::int64_t touching = 0;  // how often more lines than two meet in a vertex
  std::size_t bodies = 0, core_pieces = 0, cavity_pieces = 0, action_pieces = 0;  // connected
  std::array<std::int64_t, k_side_count> borders{};                               // loops around each side
  std::int64_t genus = 0;                                                         // summed over the bodies
  std::size_t loops = 0;                                                          // of core against cavity
  std::size_t expected_loops = 0;                                                 // genus + 1 of every body

  /// What holds for every division of a closed surface.
  [[nodiscard]] bool sums() const { return core + cavity + action == part + touching; }

  /// Handles of a side's surface; what it has with its borders filled. Twice as many, since it is a whole
  /// number only where borders and characteristic agree.
  [[nodiscard]] std::int64_t twice_handles(MoldSide side) const;

  /// Whether pieces, handles and borders of the sides account for the loops: borders of core, cavity and
  /// actions are twice the expected loops, and two more for every piece beyond a core and a cavity of each
  /// body, two less for every handle of a side, and one less where lines touch.
  [[nodiscard]] bool accounted() const;
};

/// A line is planar that climbs by no more than this share of the part's diagonal.
inline constexpr double k_planar_share = 1e-4;

struct PartingLine {
  std::vector<PartingLoop> loops;  // outer, shut-offs, actions; the longest of each first
  EulerCheck euler;
  double length = 0.0;           // of core against cavity, and against actions where they break the line
  double smoothed_length = 0.0;  // by which smoothing made it shorter
  double smoothed_climb = 0.0;   // and what of climbs and descents it took away
  double low = 0.0, high = 0.0;  // of outer loops and shut-offs
  double outer_low = 0.0, outer_high = 0.0;

  [[nodiscard]] double outer_climb() const { return outer_high - outer_low; }
  /// Whether its outer loops lie in one plane across the direction.
  [[nodiscard]] bool is_planar(double diagonal) const { return outer_climb() <= k_planar_share * diagonal; }
};

[[nodiscard]] PartingLine parting_line(const Assignment& assignment);

/// "Parting line: planar at z = 12.4 mm, no step steeper than 85°. 9 shut-offs."
[[nodiscard]] std::string parting_verdict(const Assignment& assignment, const PartingLine& line,
                                          const PartModel& model);

}  // namespace moldlight
