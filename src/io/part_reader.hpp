// Reading a part: format by content, strict, facet k of the file is facet k of the mesh.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "io/read_options.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Reads a part file of any known format; equal vertices are welded, no facet is dropped or reordered unless
/// the options choose a body or ask for a full repair (Part::file_facets has them then). Throws FileError
/// that names the place for a file that is unreadable, damaged or holds no facets, Cancelled when asked to.
[[nodiscard]] Part read_part(const std::string& path, const ReadOptions& options, const Progress& progress);

}  // namespace moldlight
