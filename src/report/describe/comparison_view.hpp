// Two revisions for a page's view.
#pragma once

#include "report/describe/describe.hpp"

namespace moldlight::report {

/// Both parts, their facets in the groups of the regions, beside each other until they are moved over each
/// other, with what differs lit.
[[nodiscard]] ModelView comparison_view(const ReportContext& context, const Comparison& comparison,
                                        const glm::dvec3& to_viewer);

}  // namespace moldlight::report
