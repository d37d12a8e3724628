// Changes of a part so that an undercut needs no side action: how far to cut back what reaches over
// it, or which window to open.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/side_action.hpp"

namespace moldlight {

/// An opening through which one half of the mold would form the undercut: all material between it and that
/// half, above its lowest surface as seen from there. Lengths and areas are in the part's unit.
struct UndercutWindow {
  bool core_side = true;  // along +d
  double area = 0.0;      // across d: of the undercut's shadow
  /// Its outline where it leaves the part, counter-clockwise seen against d; holes the other way.
  std::vector<std::vector<glm::dvec3>> loops;
  std::vector<FacetIndex> through;  // facets that it goes through, the most frequent first, eight at most
  glm::dvec3 place{0.0};            // the middle of where it leaves the part
  double least_thickness = 0.0, thickness = 0.0;  // of the material in its way: least and greatest
};

struct DesignChange {
  /// The least travel across d after which the whole undercut is clear of the part: by so much, at most, the
  /// part reaches over it. Nothing where no straight move does, but of threads and rings their depth.
  std::optional<double> depth;
  std::optional<glm::dvec3> direction;  // of that travel, unit; nothing for threads and rings
  /// On the side with less material in its way; nothing for an outline too ragged to show.
  std::optional<UndercutWindow> window;
};

/// Of each undercut of the plan. Throws Cancelled.
[[nodiscard]] std::vector<DesignChange> find_changes(const PartModel& model, const Classification& result,
                                                     const ActionSettings& settings, const ActionPlan& plan,
                                                     const Progress& progress);

}  // namespace moldlight
