// STL, binary and ASCII. Strict: a count that lies, a cut facet or a coordinate that is no number is an
// error.
#pragma once

#include <string_view>

#include "io/read_context.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// True where the size is that of a binary STL with the facet count in its header.
[[nodiscard]] bool binary_stl_size_fits(std::string_view bytes);

/// One body, named by nothing. Coordinates are the file's floats, exactly.
[[nodiscard]] Part read_binary_stl(const ReadContext& context);

/// One body a solid that has facets. Normals are not looked at: the corners' order tells the outer side.
[[nodiscard]] Part read_ascii_stl(const ReadContext& context);

}  // namespace moldlight
