// The CAD face that the user has chosen: its facets, its outline, its figures.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mold/measure.hpp"
#include "render/view_geometry.hpp"
#include "session/classification.hpp"
#include "session/part_model.hpp"

namespace moldlight::gui {

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
