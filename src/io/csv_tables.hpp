// The tables of facets and of CAD faces: area and share of each region.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mold/measure.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// One entry a facet in each span.
struct FacetTable {
  std::span<const double> areas;  // model units squared
  const FacetFractions& fractions;
  std::span<const std::uint32_t> numbers = {};  // in the file, k_no_facet for added ones; empty: facet k
  std::span<const FacetIndex> order = {};       // in which they are written; empty: as they are
};

/// Writes `facet,area,core,cavity,both,undercut`, a line a facet in the table's order (facet -1: not in the
/// file), every number in the shortest form that reads back the same; whole or not at all. Throws FileError
/// where it cannot be written.
void write_facet_csv(const std::string& path, const FacetTable& table);

/// Writes `face,area,core_share,cavity_share,both_share,undercut_share`, a line a CAD face (or polygon) in
/// the order given, the regions as shares of its area; numbers and failure as above.
void write_face_csv(const std::string& path, std::span<const SourceAreas> faces);

/// Reads a text of one direction a line: x, y, z, of any length but zero, separated by commas, semicolons or
/// white space; further columns are left aside, as are empty lines, lines that start with #, and a first line
/// of column names. Throws FileError that names the line for anything else, and for a file without a
/// direction.
[[nodiscard]] std::vector<glm::dvec3> read_directions(const std::string& path, const Progress& progress);
/// The same of a text that is in memory; `path` is what a FileError names.
[[nodiscard]] std::vector<glm::dvec3> directions_in(std::string_view text, const std::string& path);

}  // namespace moldlight
