// Lists of parting directions that users give as a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"

namespace moldlight {

/// Reads a text of one direction a line: x, y, z, of any length but zero, separated by commas, semicolons or
/// white space; further columns are left aside, as are empty lines, lines that start with #, and a first line
/// of column names. Throws FileError that names the line for anything else, and for a file without a
/// direction.
[[nodiscard]] std::vector<glm::dvec3> read_directions(const std::string& path, const Progress& progress);
/// The same of a text that is in memory; `path` is what a FileError names.
[[nodiscard]] std::vector<glm::dvec3> directions_in(std::string_view text, const std::string& path);

}  // namespace moldlight
