// What a revision asks of the mold that exists: steel to cut where the part grows, steel to add where it
// shrinks, by place, with who has it.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "actions/side_action.hpp"
#include "compare/surface_change.hpp"
#include "parting/assignment.hpp"

namespace moldlight {

/// A half, or a side action by its number in its plan; none where it is not known which.
struct SteelOwner {
  MoldSide side = MoldSide::core;
  std::optional<std::size_t> action = {};

  auto operator<=>(const SteelOwner&) const = default;
};
struct OwnedArea {
  SteelOwner owner;
  double area = 0.0;
};

/// Steel of one place that is all cut, or all added. In the part's unit.
struct SteelChange {
  MeasuredVolume volume;      // > 0
  double area = 0.0;          // of the new part's surface there
  double depth = 0.0;         // how far it reaches along the parting direction
  glm::dvec3 centre{0.0};     // of the volume
  std::vector<OwnedArea> of;  // the steel's surface: of A's mold where it is cut, of B's where it is added;
                              // the largest first
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

}  // namespace moldlight
