// Writing the lines between regions.
#pragma once

#include <string>

#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// Writes the chains of region_borders() by the extension of `path`, coordinates in the part's unit and in
/// the shortest form that reads back the same; the file is replaced whole or not at all: .obj  a polyline
/// (`l`) a chain, in a group a pair of regions (`g core-undercut`); chains share vertices; .csv
/// `chain,closed,region_a,region_b,x,y,z`, a line a point: chains from 0, closed 1 or 0, region_a left of
///       the walk as seen from outside; the first point of a closed chain comes again as its last.
/// Throws UsageError for another extension, FileError where it cannot be written.
void write_borders(const std::string& path, const SplitMesh& mesh);

/// Throws UsageError where write_borders would for the extension: to be asked before long work.
void check_border_extension(const std::string& path);

}  // namespace moldlight
