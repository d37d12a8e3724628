// PLY: ASCII and both binary orders, polygons, any further elements and properties passed over.
#pragma once

#include "io/read_context.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// One body. facet_source holds face numbers from 0 where some face is no triangle.
[[nodiscard]] Part read_ply(const ReadContext& context);

}  // namespace moldlight
