// What is said of the part's surface: at the point under the cursor, and of the CAD face that was chosen.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "mold/draft.hpp"
#include "mold/measure.hpp"
#include "render/part_view.hpp"
#include "render/view_geometry.hpp"

namespace moldlight::gui {

/// What stands in a point's way.
struct Blocker {
  FacetIndex facet = 0;
  double distance = 0.0;  // model units, along the direction of removal
  bool above = true;      // towards +d
};

/// The surface under the cursor.
struct Hover {
  PickedPoint point;
  double draft_deg = 0.0;
  FacetClass facet_class = FacetClass::up;
  std::optional<Blocker> blocker;  // the nearest, where something blocks
};

/// Draft, class and, for an undercut, what blocks it: found by exact rays, so that it names one facet.
[[nodiscard]] Hover describe(const PartModel& model, const Query& query, const PickedPoint& point);

/// A CAD face: its facets and figures.
struct ChosenFace {
  std::uint32_t number = 0;  // as in the file: see Part::facet_source
  std::vector<FacetIndex> facets;
  std::optional<SourceAreas> figures;  // of the last measuring; none yet
};

/// The face that a facet belongs to; nothing for a part whose facets belong to none.
[[nodiscard]] std::optional<ChosenFace> face_of(const PartModel& model, FacetIndex facet);

/// What `--faces` would write of this face.
[[nodiscard]] std::optional<SourceAreas> face_figures(const PartModel& model, const Classification& result,
                                                      std::uint32_t number);

/// The edges between its facets and others.
[[nodiscard]] std::vector<ViewSegment> outline_of(const PartModel& model, const ChosenFace& face);

}  // namespace moldlight::gui
