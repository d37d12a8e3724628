// OFF and its kin with colours and normals (COFF, NOFF, …), in text.
#pragma once

#include "io/read_context.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// One body. A vertex or a face a line; what follows the coordinates or the corners on it is passed over.
/// facet_source holds face numbers from 0 where some face is no triangle.
[[nodiscard]] Part read_off(const ReadContext& context);

}  // namespace moldlight
