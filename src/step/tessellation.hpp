// Reads a STEP file with OpenCASCADE and cuts its faces into triangles that meet without gaps.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "io/step_result.hpp"

namespace moldlight::step {

struct TessellationSettings {
  double linear_deflection =
      0.0;  // largest distance from the CAD surface, in the file's unit; 0: from the share
  double linear_share = 0.0005;         // of the part's diagonal
  double angular_deflection_deg = 5.0;  // largest angle between neighbouring chords
  std::uint64_t max_facets = 0;
};

/// Has OpenCASCADE read what it keeps in files and in the environment, so that it needs none later.
void prepare();

/// Solids are the bodies, in the order of the file; then shells and faces that belong to none.
[[nodiscard]] StepResult tessellate(std::istream& file, const TessellationSettings& settings);

}  // namespace moldlight::step
