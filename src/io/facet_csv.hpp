// The tables of facets and of CAD faces: area and share of each region.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mold/measure.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// One entry a facet in each span.
struct FacetTable {
  std::span<const double> areas;  // model units squared
  const FacetFractions& fractions;
  std::span<const std::uint32_t> numbers = {};  // in the file, k_no_facet for added ones; empty: facet k
};

/// Writes `facet,area,core,cavity,both,undercut`, a line a facet in the table's order (facet -1: not in the
/// file), every number in the shortest form that reads back the same; whole or not at all. Throws FileError
/// where it cannot be written.
void write_facet_csv(const std::string& path, const FacetTable& table);

/// Writes `face,area,core_share,cavity_share,both_share,undercut_share`, a line a CAD face (or polygon) in
/// the order given, the regions as shares of its area; numbers and failure as above.
void write_face_csv(const std::string& path, std::span<const SourceAreas> faces);

}  // namespace moldlight
