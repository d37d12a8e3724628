// Region areas of what the file's facets belong to: CAD faces of a STEP file, polygons of other formats.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mold/region.hpp"

namespace moldlight {

struct SourceAreas {
  std::uint32_t source = 0;  // number of the CAD face or polygon
  RegionValues areas;        // model units squared
};

/// Sums facet areas by source; one entry a facet in each span. Sources in ascending order, those that no
/// facet has left out.
[[nodiscard]] std::vector<SourceAreas> region_areas_by_source(std::span<const std::uint32_t> facet_sources,
                                                              std::span<const double> facet_areas,
                                                              const FacetFractions& fractions);

}  // namespace moldlight
