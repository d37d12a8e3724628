// The split mesh as the part's file lists its facets.
#pragma once

#include "mesh/part.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// With facets, their pieces and vertices in the file's order (see mesh/file_order), and so numbered.
[[nodiscard]] SplitMesh split_as_listed(const SplitMesh& split, const Part& part);

}  // namespace moldlight
