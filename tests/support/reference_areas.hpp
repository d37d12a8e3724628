// Reference areas of real parts (reference/areas.csv in the shared folder).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/region.hpp"

namespace moldlight::test {

struct ReferenceRow {
  std::string part;  // file name below parts/
  glm::dvec3 direction{0.0};
  double tau_deg = 0.0, lateral_tolerance = 0.0;  // degrees; the part's unit
  double total = 0.0, near_vertical = 0.0;        // the part's unit squared, as are the rest
  RegionValues areas;
  double undercut_error = 0.0;  // standard error
};

[[nodiscard]] std::vector<ReferenceRow> read_reference_areas(const std::filesystem::path& csv);

}  // namespace moldlight::test
