// Loops of the material of a flexible piece that go through a tunnel of the part: it comes off only where
// each is cut. Found from how cycles of its surface link with cycles of the part.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// For each of `count` pieces of a mold how many independent loops of what it forms, pushed out of the part,
/// link with loops inside it. `formed_by` has the piece of each piece of the mesh, which must be closed;
/// `normals` those of its source facets.
/// Nothing where the mesh is open, or has so many tunnels that this would take long. Throws Cancelled.
[[nodiscard]] std::optional<std::vector<std::size_t>> locked_loops(const SplitMesh& mesh,
                                                                   std::span<const glm::dvec3> normals,
                                                                   std::span<const std::uint32_t> formed_by,
                                                                   std::size_t count,
                                                                   const Progress& progress);

}  // namespace moldlight
