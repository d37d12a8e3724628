// What a revision asks of the mold that exists: steel to cut where the part grows, steel to add where it
// shrinks, by place, with who has it; and where its parting line leaves that of this mold.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "actions/side_action.hpp"
#include "compare/surface_change.hpp"
#include "parting/assignment.hpp"
#include "parting/loops.hpp"

namespace moldlight {

/// A half, or a side action by its number in the plan of its part; none where it is not known which.
struct SteelOwner {
  MoldSide side = MoldSide::core;
  std::optional<std::size_t> action = {};
  bool of_b = false;  // in the mold of B

  auto operator<=>(const SteelOwner&) const = default;
};
struct OwnedArea {
  SteelOwner owner;
  double area = 0.0;
};

/// Steel of one place that is all cut, or all added. In the part's unit.
struct SteelChange {
  MeasuredVolume volume;   // > 0
  double area = 0.0;       // of the new part's surface there
  double depth = 0.0;      // how far it reaches along the parting direction
  glm::dvec3 centre{0.0};  // of the volume
  // The steel's surface, of A's mold where it is cut, of B's where it is added; of a body of its own, which
  // no steel touches yet, what the other mold forms of it. The largest first.
  std::vector<OwnedArea> of;
};
struct PlaceSteel {
  std::optional<SteelChange> cut, add;
};

/// A part of the comparison with the mold that its own best line gives it.
struct MoldedSide {
  const OverlaySide& side;
  const Assignment& assignment;
  const ActionPlan* plan = nullptr;  // of the split mesh of `side`; null where it was not asked for
};

/// One for each of the change's places. Both parts must be closed. What cuts less what adds is the volume of
/// the place; where it does both, the surfaces of both are cut where they cross each other. What tolerance or
/// tessellation explain is none, and is in the error. The same to the bit for any number of threads. Throws
/// Cancelled.
[[nodiscard]] std::vector<PlaceSteel> find_steel(const MoldedSide& a, const MoldedSide& b,
                                                 const SurfaceChange& change, const Progress& progress);

/// A run of one line that is off the other. Lengths are in the part's unit.
struct LineStretch {
  double length = 0.0;
  double farthest = 0.0;  // from the other line; the part's diagonal where there is none
  glm::dvec3 at{0.0};     // where it is farthest
};

struct LineChange {
  double within = 0.0;                   // nearer than this it is the same line
  std::vector<LineStretch> added, gone;  // of B's line off A's, and of A's off B's; the longest first
};

/// Of what core and cavity meet in; `within` > 0.
[[nodiscard]] LineChange find_line_change(const PartingLine& a, const PartingLine& b, double within,
                                          double diagonal);

}  // namespace moldlight
