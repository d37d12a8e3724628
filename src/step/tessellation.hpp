// Reads a STEP file with OpenCASCADE and cuts its faces into triangles that meet without gaps.
#pragma once

#include <cstdint>
#include <string>

#include "io/step_result.hpp"

namespace moldlight::step {

struct TessellationSettings {
  double linear_deflection =
      0.0;  // largest distance from the CAD surface, in the file's unit; 0: from the share
  double linear_share = 0.0005;         // of the part's diagonal
  double angular_deflection_deg = 5.0;  // largest angle between neighbouring chords
  std::uint64_t max_facets = 0;
};

/// Solids are the bodies, in the order of the file; then shells and faces that belong to none.
[[nodiscard]] StepResult tessellate(const std::string& path, const TessellationSettings& settings);

}  // namespace moldlight::step
