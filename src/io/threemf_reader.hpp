// 3MF: build items with their transforms and components, production extension included. No file beside the
// archive is opened, and references that nest or multiply without end are stopped.
#pragma once

#include "io/read_context.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// One body for every use of a mesh, in the order of the build items. The unit is the root model's.
[[nodiscard]] Part read_threemf(const ReadContext& context);

}  // namespace moldlight
