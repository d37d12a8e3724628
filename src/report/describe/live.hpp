// Reports whose page finds the regions of any direction by itself.
#pragma once

#include "picture/sphere_map.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

/// The map of undercut as the page's ball has it; rows from below.
[[nodiscard]] Image sphere_texture(const UndercutField& field);

/// What the page's maps of this resolution are by the program's own: as wide as the part is across the
/// direction, so that a map over the whole diagonal has more texels; one-sided; and no test nearer beside a
/// wall than the texel that is looked up reaches.
[[nodiscard]] Query page_query(const PartModel& model, const Query& query, int resolution);

/// Makes the report's page live where the context asks for it: adds the part, the exact areas of `known` (the
/// direction of the view first), and how far areas by shadow maps are off, which is measured along the axes,
/// between them and along `known`. Says in the report why where the part is too large. Throws Cancelled.
void add_live(const ReportContext& context, const Classification& shown, std::vector<LiveDirection> known,
              Report& report);

}  // namespace moldlight::report
